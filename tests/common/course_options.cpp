#include "course/options.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

#include "child.hpp"
#include "scratch_folder.hpp"

using namespace sr;
using namespace sr::course;
using sr::test::in_child;

namespace {

const Defaults sizes{.size = {100, 200, 300}, .samples = ByQuality{1, 2, 3}};

Parsed parse(std::vector<const char*> words, const Defaults& defaults = sizes) {
    words.insert(words.begin(), "01_rays");
    return parse_options(int(words.size()), words.data(), "01_rays", "Rays", defaults);
}

/// What the program says, and its exit code, when it is given these words.
Ended told(const std::vector<const char*>& words, const Defaults& defaults = sizes) {
    return in_child([&] {
        const Parsed parsed = parse(words, defaults);
        return parsed.options ? 99 : parsed.exit_code;
    });
}

}  // namespace

TEST_CASE("options that nobody gives come from the quality") {
    const Options lecture = parse({}).options.value();
    CHECK(lecture.size == 200);
    CHECK(lecture.samples == 2);
    CHECK(lecture.threads >= 1);
    CHECK(lecture.out == "figures");
    CHECK(lecture.formats == std::vector<std::string>{"svg"});
    const Options draft = parse({"--quality", "draft", "--samples=7"}).options.value();
    CHECK(draft.size == 100);
    CHECK(draft.samples == 7);
}

TEST_CASE("options are read as given; the last of two holds") {
    const Options o = parse({"--size", "64", "--size", "32", "--format", "png,svg,png", "--seed",
                             "18446744073709551615", "--out", "a b", "--threads", "3"})
                          .options.value();
    CHECK(o.size == 32);
    CHECK(o.formats == std::vector<std::string>{"png", "svg"});
    CHECK(o.seed == ~std::uint64_t{0});
    CHECK(o.out == "a b");
    CHECK(o.threads == 3);
}

TEST_CASE("what is wrong is told in one line with exit code 2") {
    const struct {
        std::vector<const char*> words;
        const char*              line;
    } cases[] = {
        {{"--size", "0"}, "--size 0: the image's edge must be 16 to 8192 pixels"},
        {{"--size", "100000"}, "--size 100000: the image's edge must be 16 to 8192 pixels"},
        {{"--size", "-5"}, "--size -5: the image's edge must be 16 to 8192 pixels"},
        {{"--size", "1e3"}, "--size 1e3: the image's edge must be 16 to 8192 pixels"},
        {{"--size", "99999999999999999999"},
         "--size 99999999999999999999: the image's edge must be 16 to 8192 pixels"},
        {{"--size", "nan"}, "--size nan: the image's edge must be 16 to 8192 pixels"},
        {{"--size", ""}, "--size '': N must not be empty: longer edge of a render in pixels"},
        {{"--size"}, "--size: N must follow: longer edge of a render in pixels"},
        {{"--samples", "0"}, "--samples 0: the number of samples must be 1 to 1000000"},
        {{"--threads", "0"}, "--threads 0: the number of threads must be 1 to 1024"},
        {{"--seed", "-1"}, "--seed -1: the seed must be a whole number from 0 to 18446744073709551615"},
        {{"--out", ""}, "--out '': DIR must not be empty: folder of the figures"},
        {{"--out="}, "--out: DIR must follow: folder of the figures"},
        {{"--out", "--size", "64"}, "--out: DIR must follow: folder of the figures"},
        {{"--quality"}, "--quality: Q must follow: draft, lecture or print"},
        {{"--samples"}, "--samples: N must follow: samples per pixel of a render"},
        {{"--threads"}, "--threads: N must follow: threads to use"},
        {{"--seed"},
         "--seed: N must follow: start of the random numbers of all that is drawn; with others claims may "
         "fail"},
        {{"--quality", "best"}, "--quality best: the quality must be draft, lecture or print"},
        {{"--format", "gif"}, "--format gif: the formats must be of svg, png, pdf, tex, separated by commas"},
        {{"--format", ""}, "--format '': LIST must not be empty: of svg, png, pdf, tex, separated by commas"},
        {{"--format", "--out", "X"},
         "--format: LIST must follow: of svg, png, pdf, tex, separated by commas"},
        {{"--siez", "4"}, "--siez: unknown option; did you mean --size?; see --help"},
        {{"--bananas"}, "--bananas: unknown option; see --help"},
        {{"-q"}, "-q: unknown option; see --help"},
        {{"fast"}, "fast: unknown word; see --help"},
        {{"--scene", "x.obj"},
         "--scene: for the program of a chapter that renders a file: course run 01 --scene FILE"},
        {{"--error", "0.1"},
         "--error: for the program of a chapter that renders to an error: course run 10 --error 0.05"},
    };
    for (const auto& c : cases) {
        const Ended ended = told(c.words);
        CHECK(ended.err == "01_rays: error: " + std::string{c.line} + "\n");
        CHECK(ended.out == "");
        CHECK(ended.code == 2);
    }
}

TEST_CASE("samples that form a square are counted by squares") {
    const Defaults square{.samples = ByQuality{1, 4, 9}, .square_samples = true};
    for (const char* const samples : {"1", "4", "999999"})
        CHECK(parse({"--samples", samples}).options.value().samples >= 1);
    for (const char* const samples : {"1", "4", "1000000"})
        CHECK(parse({"--samples", samples}, square).options.has_value());
    CHECK(told({"--samples", "3"}, square).err ==
          "01_rays: error: --samples 3: a pixel's samples form a square here; the nearest are 1 and 4\n");
    CHECK(
        told({"--samples", "999999"}, square).err ==
        "01_rays: error: --samples 999999: a pixel's samples form a square here; the nearest are 998001 and "
        "1000000\n");
}

TEST_CASE("a scene is an option where a section renders one, and must be a file that is there") {
    const sr::test::ScratchFolder scratch{"options"};
    const std::string             folder = scratch.path.string(), file = folder + "/x.obj";
    std::ofstream(file) << "v 0 0 0\n";
    const Defaults renders{.scene_section = "1.2"};
    CHECK(parse({"--scene", file.c_str()}, renders).options.value().scene == file);
    CHECK(told({"--help"}, renders).out.find("section 1.2 renders it") != std::string::npos);
    CHECK(told({"--help"}).out.find("--scene") == std::string::npos);
    CHECK(told({"--scene", "no.obj"}, renders).err ==
          "01_rays: error: --scene no.obj: no such file; must be an OBJ file\n");
    CHECK(told({"--scene"}, renders).err ==
          "01_rays: error: --scene: FILE must follow: OBJ file: section 1.2 renders it, the others keep "
          "their own scenes\n");
    const Ended ended = told({"--scene", folder.c_str()}, renders);
    CHECK(ended.err == "01_rays: error: --scene " + folder + ": is no regular file; must be an OBJ file\n");
    CHECK(ended.code == 2);
}

TEST_CASE("an error is an option where a section renders to it, and a share that can be reached") {
    const Defaults renders{.error_section = "10.10"};
    CHECK(parse({"--error", "0.02"}, renders).options.value().error == 0.02);
    CHECK(parse({"--error", "1"}, renders).options.value().error == 1);
    CHECK(parse({"--error", "1e-3"}, renders).options.value().error == 0.001);
    CHECK(parse({}, renders).options.value().error == 0.2);
    CHECK(parse({"--quality", "print"}, renders).options.value().error == 0.1);
    CHECK(told({"--help"}, renders).out.find("section 10.10 is done") != std::string::npos);
    CHECK(told({"--help"}, renders).out.find("[0.4 draft, 0.2 lecture, 0.1 print]") != std::string::npos);
    CHECK(told({"--help"}).out.find("--error") == std::string::npos);
    for (const std::string wrong : {"0", "-0.1", "0.0009", "1.01", "5%", "0,05", "nan", "inf", "1e-400"}) {
        const Ended ended = told({"--error", wrong.c_str()}, renders);
        CHECK(ended.err == "01_rays: error: --error " + wrong +
                               ": the error must be 0.001 to 1, a share of the mean: 0.05 is 5 %\n");
        CHECK(ended.code == 2);
    }
    CHECK(told({"--error"}, renders).err ==
          "01_rays: error: --error: X must follow: standard error at which the render of section 10.10 is "
          "done, "
          "as a share of its mean\n");
}

TEST_CASE("an option that changes nothing gets one line, which is no error, and its help says so") {
    const Defaults fixed{.takes_seed = false};
    const auto     notes = [](const std::vector<const char*>& words, const Defaults& defaults) {
        const Ended ended = told(words, defaults);
        CHECK(ended.code == 99);  // it goes on
        return ended.err;
    };
    CHECK(notes({"--samples", "7"}, fixed) ==
          "01_rays: --samples 7 changes nothing: this chapter takes no samples\n");
    CHECK(notes({"--seed", "2"}, fixed) ==
          "01_rays: --seed 2 changes nothing: this chapter always draws the random numbers of its text\n");
    CHECK(notes({"--size", "64"}, fixed) == "");
    CHECK(notes({"--samples", "7", "--seed", "2"}, sizes) == "");

    const std::string help = told({"--help"}, fixed).out;
    CHECK(help.find("fixed: this chapter takes no samples") != std::string::npos);
    CHECK(help.find("fixed: this chapter always draws") != std::string::npos);
    CHECK(told({"--help"}).out.find("fixed") == std::string::npos);
}

TEST_CASE("help says what samples and seed act on, in the words of the chapter") {
    const std::string help =
        told({"--help"}, {.samples = ByQuality{1, 2, 3}, .sampled_each = "ball, 9.2", .seeded = "balls, 9.2"})
            .out;
    CHECK(help.find("samples per ball, 9.2 [1 draft, 2 lecture, 3 print]") != std::string::npos);
    CHECK(help.find("start of the random numbers of balls, 9.2 [1]") != std::string::npos);
}

TEST_CASE("help names every option with its default") {
    const Ended ended = told({"--help"});
    CHECK(ended.code == 0);
    CHECK(ended.err == "");
    for (const char* word : {"--out", "--quality", "--size", "--samples", "--threads", "--seed", "--format",
                             "[figures; with course: its own folder figures]",
                             "[100 draft, 200 lecture, 300 print]", "[all cores"})
        CHECK(ended.out.find(word) != std::string::npos);
}

namespace {

/// What the commands of a small program got.
struct Got {
    int       code = -1;
    Arguments arguments;
};

Got give(std::vector<const char*> words) {
    Got        got;
    const auto keep = [&](const Arguments& arguments) {
        got.arguments = arguments;
        return 5;
    };
    words.insert(words.begin(), "course");
    got.code = dispatch(int(words.size()), words.data(), "course", "The commands.\n",
                        {{.name         = "figures",
                          .help         = "h",
                          .rest         = Rest::words,
                          .rest_name    = "NN",
                          .options      = {{"--publish", "", "p"}},
                          .takes_shared = true,
                          .run          = keep},
                         {.name = "run", .help = "h", .rest = Rest::verbatim, .rest_name = "NN", .run = keep},
                         {.name      = "bench",
                          .help      = "h",
                          .rest      = Rest::words,
                          .rest_name = "TOPIC",
                          .options   = {{"--csv", "FILE", "c"}},
                          .run       = keep,
                          .help_on   = [](const auto& rest) { return "of " + rest.front(); }},
                         {.name = "docs", .help = "h", .run = keep}});
    return got;
}

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("commands get their words, their options and the shared ones") {
    const Got figures = give({"figures", "01", "--size", "64", "02", "--publish"});
    CHECK(figures.code == 5);
    CHECK(figures.arguments.rest == Words{"01", "02"});
    CHECK(figures.arguments.shared == Words{"--size", "64"});
    CHECK(figures.arguments.has("--publish"));
    CHECK_FALSE(give({"figures"}).arguments.has("--publish"));

    CHECK(give({"run", "01", "--help", "--foo", "-x", "3"}).arguments.rest ==
          Words{"01", "--help", "--foo", "-x", "3"});

    const Got bench = give({"bench", "rays", "--csv", "a.csv"});
    CHECK(bench.arguments.rest == Words{"rays"});
    CHECK(bench.arguments.value("--csv") == "a.csv");
    CHECK(give({"bench"}).arguments.value("--csv") == std::nullopt);
}

TEST_CASE("a program of one command reads its options as a command does") {
    const auto run = [](std::vector<const char*> words) {
        words.insert(words.begin(), "bench_rays");
        const Command command{.name    = "bench_rays",
                              .help    = "Rays.",
                              .options = {{"--csv", "FILE", "c"}},
                              .run     = [](const Arguments& a) { return a.value("--csv") == "x" ? 5 : 6; }};
        return in_child([&] { return run_command(int(words.size()), words.data(), command); });
    };
    CHECK(run({"--csv", "x"}).code == 5);
    CHECK(run({}).code == 6);
    CHECK(run({"--help"}).out.starts_with("Rays.\n\nusage: bench_rays [option...]\n"));
    CHECK(run({"--foo"}).code == 2);
    CHECK(run({"--foo"}).err == "bench_rays: error: --foo: unknown option; see --help\n");
}

TEST_CASE("a mistaken command is told in one line with exit code 2") {
    const struct {
        std::vector<const char*> words;
        const char*              line;
    } cases[] = {{{"figrues"}, "figrues: unknown command; did you mean figures?; see course --help"},
                 {{"figures", "--size", "0"}, "--size 0: the image's edge must be 16 to 8192 pixels"},
                 {{"figures", "--pubish"}, "--pubish: unknown option; did you mean --publish?; see --help"},
                 {{"run", "--size", "3"}, "--size: unknown option; see --help"},
                 {{"bench", "rays", "--foo"}, "--foo: unknown option; see --help"},
                 {{"docs", "now"}, "now: unknown word; see --help"},
                 {{"bench", "--csv"}, "--csv: FILE must follow: c"}};
    for (const auto& c : cases) {
        const Ended ended = in_child([&] { return give(c.words).code; });
        CHECK(ended.err == "course: error: " + std::string{c.line} + "\n");
        CHECK(ended.code == 2);
    }
}

TEST_CASE("without a command, and with --help, the help is shown") {
    for (const auto& words : {std::vector<const char*>{}, {"--help"}, {"-h"}, {"help"}}) {
        const Ended ended = in_child([&] { return give(words).code; });
        CHECK(ended.code == 0);
        CHECK(ended.out == "The commands.\n");
    }
    const Ended bench = in_child([] { return give({"bench", "--help"}).code; });
    CHECK(bench.code == 0);
    CHECK(bench.out.starts_with("h\n\nusage: course bench TOPIC [option...]\n"));
    CHECK(bench.out.find("--csv FILE") != std::string::npos);
    const Ended rays = in_child([] { return give({"bench", "rays", "--help"}).code; });
    CHECK(rays.code == 0);
    CHECK(rays.out.starts_with("of rays\n\nusage: course bench TOPIC [option...]\n"));
    const Ended run = in_child([] { return give({"run", "--help"}).code; });
    CHECK(run.out.starts_with("h\n\nusage: course run NN\n"));
    const Ended figures = in_child([] { return give({"figures", "--help"}).code; });
    CHECK(figures.out.find("pixels [the chapter's]") != std::string::npos);
}
