#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <locale>
#include <stdexcept>

#include "course/claim.hpp"
#include "course/csv.hpp"
#include "course/number.hpp"
#include "course/progress.hpp"
#include "course/table.hpp"
#include "course/tex.hpp"
#include "image/whole_file.hpp"
#include "scratch_folder.hpp"

using namespace sr;
using namespace sr::course;

TEST_CASE("numbers are written in the fewest digits that read back the same") {
    CHECK(Cell{0.1}.text() == "0.1");
    CHECK(Cell{0.1F}.text() == "0.1");
    CHECK(Cell{1.0 / 3}.text() == "0.3333333333333333");
    CHECK(Cell{1e300}.text() == "1e+300");
    CHECK(Cell{std::int64_t{-7}}.text() == "-7");
    CHECK(Cell{std::numeric_limits<double>::infinity()}.text() == "inf");
    CHECK(Cell{true}.text() == "yes");
    CHECK(std::isnan(Cell{"text"}.number()));
}

TEST_CASE("a CSV reads back as it was written") {
    const test::ScratchFolder folder{"csv"};
    Rows                      table{{"name", "a, b [m]", "n"}};
    table.add({"plain", 0.1, 3});
    table.add({"comma, \"quote\"\nnew line", -0.0, std::numeric_limits<std::int64_t>::max()});
    table.add({"", std::numeric_limits<double>::denorm_min(), -1});
    write_csv(folder.path / "t.csv", table);
    const Rows back = read_csv(folder.path / "t.csv");
    CHECK(back.header == table.header);
    REQUIRE(back.rows.size() == 3);
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            CHECK(back.rows[row][column].text() == table.rows[row][column].text());
    CHECK(back.rows[0][1].is_number());
    CHECK(std::signbit(back.rows[1][1].number()));
}

TEST_CASE("a damaged CSV is told with file and row") {
    const test::ScratchFolder folder{"csv_bad"};
    const auto                complaint = [&](const char* text) {
        write_whole_file(folder.path / "t.csv", text);
        try {
            (void)read_csv(folder.path / "t.csv");
        } catch (const std::exception& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    CHECK(complaint("a,b\n1,2\n3\n").ends_with("t.csv, row 3: a row of 1 cells for the 2 columns a, b"));
    CHECK(complaint("").ends_with("row 1: the file is empty; a header must come first"));
    CHECK(complaint("a\n\"x\n").ends_with("row 2: a quote is opened and not closed"));
    CHECK_THROWS_AS((void)read_csv(folder.path / "none.csv"), std::runtime_error);
}

TEST_CASE("a table aligns numbers right and text left, counting letters and not bytes") {
    Rows table{{"näme", "value"}};
    table.add({"x", 1.5});
    table.add({"°°°°°°", 22});
    CHECK(to_text(table) == "  näme     value\n  x          1.5\n  °°°°°°      22\n");
}

TEST_CASE("whole numbers are grouped from five digits on") {
    CHECK(whole(0) == "0");
    CHECK(whole(1024) == "1024");
    CHECK(whole(-1024) == "-1024");
    CHECK(whole(65280) == "65\u00a0280");
    CHECK(whole(-100'000) == "-100\u00a0000");
    CHECK(whole(1'000'000) == "1\u00a0000\u00a0000");
    CHECK(counted(1, "ray") == "1 ray");
    CHECK(counted(65280, "triangle") == "65\u00a0280 triangles");
    Rows table{{"n"}};
    table.add({65280});
    CHECK(to_text(table).ends_with("  65\u00a0280\n"));
}

TEST_CASE("a value has the digits that its tolerance lets count") {
    CHECK(to_tolerance(39.30765, 5e-5) == "39.30765");
    CHECK(to_tolerance(39.307649, 5e-5) == "39.30765");
    CHECK(to_tolerance(1.9, 0.05) == "1.90");
    CHECK(to_tolerance(1.9141, 0.05) == "1.91");
    CHECK(to_tolerance(2.84217e-13, 1e-9) == "2.8e-13");
    CHECK(to_tolerance(-115.352, 1) == "-115");
    CHECK(to_tolerance(61195, 0) == "61\u00a0195");
    CHECK(to_tolerance(61195.25, 100) == "61195");
    CHECK(to_tolerance(0.1 + 0.2, 0) == "0.30000000000000004");
    CHECK(to_tolerance(0, 0.5) == "0");
    CHECK(to_tolerance(std::numeric_limits<double>::quiet_NaN(), 0.5) == "nan");
}

TEST_CASE("a table of claims shows how far the measured is from the expected, or from its bound") {
    const std::vector<Claim> claims{
        {"1.3 a", {39.3, 39.30012, 5e-4}}, at_most("1.1 b", 3.25e-14, 1e-9), at_most("1.1 c", 2, 0.5)};
    CHECK(to_text(to_table(claims), claim_text) ==
          "  claim   expected   measured     error   tolerance   pass\n"
          "  1.3 a    39.3000    39.3001   0.00012      0.0005   yes\n"
          "  1.1 b   <= 1e-09   3.25e-14                         yes\n"
          "  1.1 c     <= 0.5          2                         no\n");
    CHECK(to_csv(to_rows({at_most("1.1 c", 2, 0.5)})) ==
          "claim,expected,measured,error,tolerance,pass\n1.1 c (at most 0.5),0,1.5,1.5,0,no\n");
}

TEST_CASE("TeX becomes gnuplot's text, LaTeX and HTML") {
    const std::string ray = "ray $\\mathbf{o} + t\\,\\mathbf{d}$";
    CHECK(tex_to_html(ray) == "ray <b>o</b>\u00a0+\u00a0<i>t</i>\u2009<b>d</b>");
    CHECK(tex_to_enhanced(ray) == "ray {/serif:Bold o}\u00a0+\u00a0{/serif:Italic t}\u2009{/serif:Bold d}");
    CHECK(tex_to_latex(ray) == ray);
    CHECK(tex_to_latex("a \"hit\", (\"$t$ in $T$\")") ==
          "a ``hit{\\textquotedblright}, (``$t$ in $T${\\textquotedblright})");
    CHECK(tex_to_html("$t_{\\min}$, $n^{-1/2}$") == "<i>t</i><sub>min</sub>, <i>n</i><sup>−1/2</sup>");
    CHECK(tex_to_enhanced("$\\omega_i$") == "{/serif:Italic ω}_{{/serif:Italic i}}");
    CHECK(tex_to_plain("$\\sin\\theta \\le 1$ at \\$5") == "sin\u2009θ\u00a0≤\u00a01 at $5");
    CHECK(tex_to_enhanced("$\\mathbf{n} \\cdot \\mathbf{d}$") ==
          "{/serif:Bold n}\u2009·\u2009{/serif:Bold d}");
    CHECK(tex_to_html("$x = -1$") == "<i>x</i>\u00a0=\u00a0−1");
}

TEST_CASE("an exponent stands above the index where both are short, and after it where they are not") {
    CHECK(tex_to_enhanced("$r_1^2$") == "{/serif:Italic r}@_{1}^{/*0.99 2}");
    CHECK(tex_to_enhanced("$r^2_1$") == "{/serif:Italic r}@^{2}_{/*0.99 1}");
    CHECK(tex_to_enhanced("$r_{12}^2$") == "{/serif:Italic r}_{12}^{/*0.99 2}");
    CHECK(tex_to_enhanced("$r_1 s^2$") == "{/serif:Italic r}_{1}{/serif:Italic s}^{2}");
    CHECK(tex_to_html("$r_1^2$") == "<i>r</i><sub>1</sub><sup>2</sup>");
}

TEST_CASE("outside of formulas every character stands for itself") {
    const std::string odd = "a_b 50% & x^2 @ {q} ~ # \\ <y>";
    CHECK(tex_to_plain(odd) == odd);
    CHECK(tex_to_enhanced(odd) == "a\\_b 50% \\& x\\^2 \\@ \\{q\\} \\~ # \\\\ <y>");
    CHECK(tex_to_latex(odd) ==
          "a\\_b 50\\% \\& x\\textasciicircum{}2 @ \\{q\\} \\textasciitilde{} \\# \\textbackslash{} $<$y$>$");
    CHECK(tex_to_html(odd) == "a_b 50% &amp; x^2 @ {q} ~ # \\ &lt;y&gt;");
}

TEST_CASE("TeX that can't be shown is told by name, for every kind of picture") {
    for (const char* wrong : {"$x", "$\\foo$", "${x$", "$x}$", "$x_$", "$\\frac{1}$"}) {
        CHECK_THROWS_AS((void)tex_to_enhanced(wrong), std::invalid_argument);
        CHECK_THROWS_AS((void)tex_to_latex(wrong), std::invalid_argument);
    }
    CHECK_THROWS_WITH((void)tex_to_html("$a\\foo$"), "$a\\foo$: \\foo is not known");
}

TEST_CASE("a claim holds within its tolerance, and NaN fails") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(Claim{"", {1, 1.5, 0.5}}.pass());
    CHECK(Claim{"", {0, 0, 0}}.pass());
    CHECK(!Claim{"", {1, 1.6, 0.5}}.pass());
    CHECK(!Claim{"", {1, nan, 0.5}}.pass());
    CHECK(!Claim{"", {1, 1, nan}}.pass());
    CHECK(at_most("", 1, 1).pass());
    CHECK(at_most("", -5, 1).value.measured == 0);
    CHECK(at_most("", 3, 1).value.measured == 2);
    CHECK(!at_most("", 3, 1).pass());
    CHECK(!at_most("", nan, 1).pass());
    CHECK(!at_most("", 1, nan).pass());
    CHECK(to_csv(to_rows(std::vector{Claim{"1.3 a, b", {2, 1.5, 0.25}}})) ==
          "claim,expected,measured,error,tolerance,pass\n\"1.3 a, b\",2,1.5,0.5,0.25,no\n");
}

TEST_CASE(
    "parts of a progress add up to all of its steps, also where these are few, or too many for an int to "
    "count") {
    for (const auto& [steps, parts] : {std::pair{100, 7}, {3, 10}, {1, 1}, {2'000'000'000, 3000}}) {
        std::int64_t done = 0;
        for (int part = 1; part <= parts; ++part) {
            const int now = steps_of_part(steps, part, parts);
            CHECK(now >= 0);
            CHECK(now <= steps / parts + 1);
            done += now;
        }
        CHECK(done == steps);
    }
}

TEST_CASE("progress is shown for what takes over two seconds, with the time left") {
    CHECK(progress_line("rendering", 0.5, 0.9) == "");   // 1.8 s in all
    CHECK(progress_line("rendering", 0.01, 0.1) == "");  // too early to tell
    CHECK(progress_line("rendering", 0, 5) == "");
    CHECK(progress_line("rendering", 0.25, 10).ends_with(" 25 %, 30 s left"));
    CHECK(progress_line("rendering", 0.01, 10).ends_with("  1 %, 16 min left"));
}
