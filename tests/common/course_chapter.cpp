#include "course/chapter.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "child.hpp"
#include "course/interruptible.hpp"
#include "scratch_folder.hpp"

using namespace sr;
using namespace sr::course;
using sr::test::in_child;
using sr::test::read_text;
using sr::test::ScratchFolder;

namespace {

/// A chapter's program in a process of its own, writing into `out`.
Ended run_program(const std::filesystem::path& out, const Lecture& lecture,
                  std::vector<const char*> more = {}, const std::function<void(pid_t)>& meanwhile = {}) {
    const std::string        folder = out.string();
    std::vector<const char*> words{"99_demo", "--out", folder.c_str()};
    words.insert(words.end(), more.begin(), more.end());
    return in_child([&] { return run(int(words.size()), words.data(), "99_demo", "Demo", lecture); },
                    meanwhile);
}

void small_chapter(Chapter& chapter) {
    chapter.section("99.1 A section");
    Chart chart = chapter.chart("line", "A line & more", {.x = "x [m]", .y = "y [m]"});
    for (int i = 0; i < 4; ++i) chart.add("curve", i, i);
    chart.caption("slope $1$");
    Diagram diagram = chapter.diagram("arrow", "An arrow");
    diagram.arrow({0, 0}, {1, 1});
    chapter.render("grey", "A grey image", "All $L = 0.5$", Image<Spectrum>(32, 16, {0.5F, 0.5F, 0.5F}));
    chapter.say("took 3 s");
    chapter.claim("99.1 one, or nearly", {.expected = 1, .measured = 1.25, .tolerance = 0.25});
}

/// Sends Ctrl-C to the child as soon as it has made the file.
void interrupt_once_there(pid_t child, const std::filesystem::path& file) {
    while (!std::filesystem::exists(file) && test::runs(child)) std::this_thread::yield();
    ::kill(child, SIGINT);
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a chapter leaves its figures, their captions, its claims and the page of all figures") {
    const ScratchFolder out{"chapter"};
    const Ended         ended  = run_program(out.path, small_chapter);
    const auto          folder = out.path / "99_demo";
    CHECK(ended.code == 0);
    CHECK(ended.err == "");
    CHECK(contains(ended.out, "99.1 A section"));
    CHECK(contains(ended.out, "1 claim, all hold"));
    CHECK(read_text(folder / "line.csv") ==
          "series,x [m],y [m]\ncurve,0,0\ncurve,1,1\ncurve,2,2\ncurve,3,3\n");
    CHECK(read_text(folder / "claims.csv") ==
          "claim,expected,measured,error,tolerance,pass\n\"99.1 one, or nearly\",1,1.25,0.25,0.25,yes\n");
    CHECK(std::filesystem::file_size(folder / "grey.png") > 0);
    CHECK(std::filesystem::file_size(folder / "grey.hdr") > 0);
    const Rows captions = read_csv(folder / "captions.csv");
    REQUIRE(captions.rows.size() == 3);
    const auto name = captions.column("figure");
    CHECK(captions.rows[0][name].text() == "line");  // in the chapter's order
    CHECK(captions.rows[1][name].text() == "arrow");
    CHECK(captions.rows[2][name].text() == "grey");
    const std::string page = read_text(out.path / "index.html");
    for (const char* part :
         {"<h2>99 Demo</h2>", "99_demo/grey.png", "99_demo/grey.hdr", "A line &amp; more", "99_demo/line.csv",
          "<i>L</i>", "A grey image", "99.1 one, or nearly", "class=\"yes\""})
        CHECK(contains(page, part));
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        CHECK(entry.path().filename().string().front() != '.');
}

TEST_CASE(
    "a folder beside the chapter's whose files are none of ours is left out of the page, and a line says "
    "so") {
    const ScratchFolder out{"chapter_siblings"};
    CHECK(run_program(out.path, small_chapter).code == 0);
    std::filesystem::rename(out.path / "99_demo", out.path / "98_whole");
    const auto write = [&](const char* folder, const char* file, const char* text) {
        std::filesystem::create_directories(out.path / folder);
        std::ofstream{out.path / folder / file} << text;
    };
    write("a_damaged", "captions.csv", "damaged\n1,2\n");
    write("b_foreign", "captions.csv", "image,text\ncat.png,A cat\n");
    write("c_claims", "captions.csv", "chapter,figure,kind,title,caption,files\n");
    write("c_claims", "claims_shown.csv", "claim\nthe earth is flat\n");
    const Ended ended = run_program(out.path, small_chapter);
    CHECK(ended.code == 0);
    CHECK(contains(ended.out, "1 claim, all hold"));
    const auto note = [&](const char* folder, const std::string& reason) {
        const std::string path = (out.path / folder).string();
        return fmt::format("99_demo: index.html leaves out {}: {}\n", path,
                           fmt::format(fmt::runtime(reason), path));
    };
    CHECK(ended.err ==
          note("a_damaged", "{}/captions.csv, row 2: a row of 2 cells for the 1 columns damaged") +
              note("b_foreign", "no column chapter; there are image, text") +
              note("c_claims", "{}/claims_shown.csv is no table of claims"));
    const std::string page = read_text(out.path / "index.html");
    CHECK(contains(page, "98_whole/grey.png"));
    CHECK(contains(page, "99_demo/grey.png"));
    CHECK(!contains(page, "b_foreign"));
}

TEST_CASE("without gnuplot the data are written and one sentence says so") {
    const ScratchFolder out{"chapter_no_gnuplot"};
    const Ended         ended = run_program(out.path, [](Chapter& chapter) {
        ::setenv("PATH", "/no/such/folder", 1);
        small_chapter(chapter);
    });
    CHECK(ended.code == 0);
    CHECK(contains(ended.out, "\n1 render and the data of 2 charts in "));
    CHECK(contains(ended.out, "gnuplot was not found: install it"));
    CHECK(std::filesystem::exists(out.path / "99_demo" / "line.csv"));
    CHECK(!std::filesystem::exists(out.path / "99_demo" / "line.svg"));
}

TEST_CASE("a figure that is remade in one format leaves no older one of another, but what a person made") {
    const ScratchFolder out{"chapter_formats"};
    const auto          folder = out.path / "99_demo";
    CHECK(run_program(out.path, small_chapter, {"--format", "svg,tex"}).code == 0);
    const bool drawn = std::filesystem::exists(folder / "line.tex");  // where gnuplot is
    std::ofstream{folder / "line.pdf"} << "my own";
    const Ended again = run_program(out.path, small_chapter, {"--format", "svg"});
    CHECK(again.code == 0);
    CHECK(contains(again.out, "removed, as older than their data: line.tex, arrow.tex\n") == drawn);
    CHECK(std::filesystem::exists(folder / "line.svg") == drawn);
    CHECK(!std::filesystem::exists(folder / "line.tex"));
    CHECK(read_text(folder / "line.pdf") == "my own");
    CHECK(std::filesystem::exists(folder / "grey.hdr"));
    CHECK(!contains(read_text(out.path / "index.html"), "line.tex"));

    const Ended undrawn = run_program(out.path, [](Chapter& chapter) {
        ::setenv("PATH", "/no/such/folder", 1);
        small_chapter(chapter);
    });
    CHECK(contains(undrawn.out, "removed, as older than their data: line.svg, arrow.svg\n") == drawn);
    CHECK(!std::filesystem::exists(folder / "line.svg"));

    std::ofstream{out.path / "own.svg"} << "my own";
    std::ofstream{folder / "captions.csv"} << "figure,kind,title,caption,files\n"
                                              "line,chart,,,../own.svg .. line.pdf\n";
    CHECK(run_program(out.path, small_chapter).code == 0);
    CHECK(read_text(out.path / "own.svg") == "my own");
    CHECK(!std::filesystem::exists(folder / "line.pdf"));  // listed, and so no longer a person's

    std::ofstream{folder / "captions.csv"} << "damaged\n1,2\n";
    CHECK(run_program(out.path, small_chapter).code == 0);
}

TEST_CASE("a claim that fails, NaN too, makes the program exit with 1") {
    for (const double measured : {2.0, std::nan("")}) {
        const ScratchFolder out{"chapter_claim"};
        const Ended         ended = run_program(out.path, [&](Chapter& chapter) {
            chapter.claim("good", {.expected = 1, .measured = 1, .tolerance = 0});
            chapter.claim_at_most("bad", measured, 1);
        });
        CHECK(ended.code == 1);
        CHECK(contains(ended.out, "1 of 2 claims failed"));
        CHECK(contains(read_text(out.path / "99_demo" / "claims.csv"), ",no\n"));
        CHECK(contains(read_text(out.path / "index.html"),
                       std::isnan(measured) ? "<td>&lt;= 1</td><td>nan</td>" : "<td>&lt;= 1</td><td>2</td>"));
    }
}

TEST_CASE("an error is one line and exit code 2") {
    const ScratchFolder out{"chapter_error"};
    const auto          line = [&](const Lecture& lecture) {
        const Ended ended = run_program(out.path, lecture);
        CHECK(ended.code == 2);
        return ended.err;
    };
    CHECK(line([](Chapter&) { throw std::runtime_error("x.obj, line 3:\nno such vertex"); }) ==
          "99_demo: error: x.obj, line 3: no such vertex\n");
    CHECK(line([](Chapter&) { (void)std::filesystem::file_size("no such/file"); }) ==
          "99_demo: error: no such/file: No such file or directory\n");
    CHECK(line([](Chapter& c) {
              (void)c.diagram("a", "");
              (void)c.diagram("a", "");
          }) == "99_demo: error: figure a: this name is taken\n");
    CHECK(line([](Chapter& c) { (void)c.diagram("../a", ""); }) ==
          "99_demo: error: figure ../a: its name must be of a-z, 0-9 and _\n");
}

TEST_CASE("a folder that can't be written is told before any work is done") {
    const ScratchFolder out{"chapter_unwritable"};
    std::ofstream{out.path / "file"} << "x";
    const Ended ended = run_program(out.path / "file", [](Chapter&) { std::abort(); });
    CHECK(ended.code == 2);
    CHECK(contains(ended.err, "99_demo: error: --out "));
    CHECK(ended.err.ends_with(": Not a directory\n"));
    const Ended proc = run_program("/proc/figures", [](Chapter&) { std::abort(); });
    CHECK(proc.code == 2);
    CHECK(contains(proc.err, "99_demo: error: --out /proc/figures: "));
}

TEST_CASE("Ctrl-C in a long operation ends the program with 130 at once, and all figures stay whole") {
    const ScratchFolder out{"chapter_interrupt"};
    CHECK(run_program(out.path, small_chapter).code == 0);
    const std::string before = read_text(out.path / "99_demo" / "line.csv");
    const auto        start  = std::chrono::steady_clock::now();
    const Ended       ended  = run_program(
               out.path,
               [&](Chapter& chapter) {
            Chart chart = chapter.chart("line", "", {.x = "x", .y = "y"});
            chart.add("other", 1, 1);
            std::ofstream{out.path / "started"} << "x";
            Progress progress{"forever", 1'000'000};
            for (;;) progress.tick(0);
        },
               {}, [&](pid_t child) { interrupt_once_there(child, out.path / "started"); });
    CHECK(ended.code == 130);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
    CHECK(read_text(out.path / "99_demo" / "line.csv") == before);
}

TEST_CASE("a lecture that Ctrl-C may end early saves what it has, says so, and its program ends with 130") {
    const ScratchFolder out{"chapter_interruptible"};
    const auto          folder = out.path / "99_demo";
    const Ended         ended  = run_program(
                 out.path,
                 [&](Chapter& chapter) {
            const Interruptible interrupt;
            std::ofstream{out.path / "started"} << "x";
            while (!interrupt.asked()) std::this_thread::yield();
            small_chapter(chapter);
            throw Interrupted{};
        },
                 {}, [&](pid_t child) { interrupt_once_there(child, out.path / "started"); });
    CHECK(ended.code == 130);
    CHECK(contains(ended.out, "1 claim, all hold"));
    CHECK(ended.err == "99_demo: interrupted: 3 figures so far in " + folder.string() + "\n");
    CHECK(read_csv(folder / "captions.csv").rows.size() == 3);
    CHECK(std::filesystem::exists(folder / "line.csv"));
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        CHECK(entry.path().filename().string().front() != '.');
}

TEST_CASE(
    "the second Ctrl-C ends a lecture that saves what it has, and so does the first once all is saved") {
    const ScratchFolder out{"chapter_interruptible_twice"};
    const auto          forever = [] {
        for (;;) std::this_thread::yield();
    };
    const auto second = [&](Chapter&) {
        const Interruptible interrupt;
        std::ofstream{out.path / "started"} << "x";
        while (!interrupt.asked()) std::this_thread::yield();
        std::ofstream{out.path / "asked"} << "x";
        forever();
    };
    const auto after = [&](Chapter&) {
        { const Interruptible interrupt; }
        std::ofstream{out.path / "saved"} << "x";
        forever();
    };
    const Ended twice = run_program(out.path, second, {}, [&](pid_t child) {
        interrupt_once_there(child, out.path / "started");
        interrupt_once_there(child, out.path / "asked");
    });
    CHECK(twice.code == 130);
    CHECK(twice.err == "99_demo: interrupted: before its first figure\n");
    CHECK_FALSE(std::filesystem::exists(out.path / "99_demo"));
    const Ended once = run_program(out.path, after, {},
                                   [&](pid_t child) { interrupt_once_there(child, out.path / "saved"); });
    CHECK(once.code == 130);
}

TEST_CASE("a figure is written when its section ends, and an interrupt says where those are that were") {
    const ScratchFolder out{"chapter_sections"};
    const auto          folder = out.path / "99_demo";
    const Ended         ended  = run_program(out.path, [&](Chapter& chapter) {
        small_chapter(chapter);
        Chart open = chapter.chart("open", "Filled in two sections", {.x = "x", .y = "y"});
        open.add("curve", 0, 0);
        chapter.section("99.2 Another section");
        open.add("curve", 1, 1);
        std::raise(SIGINT);
    });
    CHECK(ended.code == 130);
    CHECK(ended.err == "99_demo: interrupted: 3 figures so far in " + folder.string() + "\n");
    CHECK(std::filesystem::exists(folder / "line.csv"));
    CHECK(std::filesystem::exists(folder / "arrow.csv"));
    CHECK_FALSE(std::filesystem::exists(folder / "open.csv"));
}

TEST_CASE(
    "a chapter that ends before its first figure leaves no empty folder, and a reader that left is told "
    "nothing") {
    for (const auto& [signal, said] :
         {std::pair{SIGINT, "99_demo: interrupted: before its first figure\n"}, {SIGPIPE, ""}}) {
        const ScratchFolder out{"chapter_empty"};
        const auto          folder = out.path / "99_demo";
        const auto          end    = [&](Chapter&) { std::raise(signal); };
        const Ended         ended  = run_program(out.path, end);
        CHECK(ended.code == 128 + signal);
        CHECK(ended.err == said);
        CHECK_FALSE(std::filesystem::exists(folder));

        std::filesystem::create_directories(folder);
        std::ofstream{folder / "mine"} << "a person's own";
        CHECK(run_program(out.path, end).code == 128 + signal);
        CHECK(std::filesystem::exists(folder / "mine"));
    }
}

TEST_CASE("measured work is timed as often as asked, all in turn, after a warm-up where it is short") {
    std::string order;
    const auto  timings = measure({{"a", [&] { order += 'a'; }}, {"b", [&] { order += 'b'; }}}, 3);
    CHECK(order == "abababab");  // a warm-up, and three that count
    REQUIRE(timings.size() == 2);
    CHECK(timings[1].name == "b");
    CHECK(timings[0].seconds >= 0);
    CHECK(timings[0].seconds <= timings[0].slowest);
}

TEST_CASE("of repeats that were disturbed the one counts that was not") {
    int        run     = 0;
    const auto timings = measure({{"busy machine",
                                   [&] {  // the warm-up, then three of which but one is left alone
                                       if (run++ != 2)
                                           std::this_thread::sleep_for(std::chrono::milliseconds(20));
                                   }}},
                                 3);
    CHECK(timings[0].seconds < 0.02);  // [s]
    CHECK(timings[0].slowest >= 0.02);
}
