/// @file main.cpp
/// The command `course`: finds a chapter, a benchmark or the tests, builds what they need, runs them.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "course/csv.hpp"
#include "course/options.hpp"
#include "course/program.hpp"
#include "course/table.hpp"
#include "course/terminal.hpp"

namespace {

namespace fs     = std::filesystem;
namespace course = sr::course;
using Words      = std::vector<std::string>;

const fs::path source_folder = STERADIAN_SOURCE_DIR;
const fs::path build_folder  = STERADIAN_BINARY_DIR;

std::string program(const std::string& name) {
    return (build_folder / "bin" / name).string();
}

std::string read_text(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// What follows `start` on the first line of a file that begins with it, an @command left out; empty where none does.
std::string first_line_after(const std::string& start, const fs::path& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(start) && !line.starts_with(start + "@")) return line.substr(start.size());
    return "";
}

// ---------------------------------------------------------------------------------------- building

/// Shows of what a build says: its steps, on a terminal; warnings and errors, not the commands behind them.
class BuildLog {
public:
    void operator()(std::string_view line) {
        const bool is_noise = line.starts_with("[0/") || line.starts_with("-- ") ||
                              line.starts_with("ninja: no ") || line.starts_with("ninja: build stopped") ||
                              line.find(" -c ") != std::string_view::npos;
        if (is_noise || line == last_) return;  // an assembler on a full disk complains a hundred times
        last_ = line;
        if (!line.starts_with('[')) {
            clear();
            fmt::print(stderr, "{}\n", line);
        } else if (course::stderr_is_terminal()) {
            fmt::print(stderr, "\r\x1b[K{}", line.substr(0, 78));  // a line that wraps could not be cleared
            std::fflush(stderr);
            is_shown_ = true;
        } else if (line.starts_with("[1/") && line.find(']') > 4) {  // ten steps or more
            fmt::print(stderr, "course: building, this takes a minute or more\n");
        }
    }

    void clear() {
        if (is_shown_) fmt::print(stderr, "\r\x1b[K");
        is_shown_ = false;
    }

private:
    std::string last_;
    bool        is_shown_ = false;
};

/// Brings targets up to date; all of them where none is named. @return the build's exit code
int build(const Words& targets) {
    Words words = {"cmake", "--build", build_folder.string()};
    if (!targets.empty()) words.emplace_back("--target");
    words.insert(words.end(), targets.begin(), targets.end());

    BuildLog  log;
    const int code = course::run_program(words, std::ref(log));
    log.clear();
    return code;
}

// ---------------------------------------------------------------------------------------- chapters

/// The folders of chapters/ that hold a program, in order: "01_rays", ...
Words chapters() {
    Words names;
    for (const auto& entry : fs::directory_iterator(source_folder / "chapters"))
        if (fs::exists(entry.path() / "main.cpp")) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// The chapter that a person calls 1, 01, rays or 01_rays.
std::string chapter_named(const std::string& word) {
    const Words known = chapters();
    for (const std::string& name : known) {
        const std::string number = name.substr(0, 2);
        if (word == name || word == name.substr(3) || word == number || "0" + word == number) return name;
    }
    throw std::invalid_argument(
        fmt::format("there is no chapter '{}'; there are {}", word, fmt::join(known, ", ")));
}

/// The first heading of its text.
std::string title_of(const std::string& chapter) {
    return first_line_after("# ", source_folder / "chapters" / chapter / "README.md");
}

bool names_out(const Words& options) {
    return std::any_of(options.begin(), options.end(),
                       [](const std::string& word) { return word == "--out" || word.starts_with("--out="); });
}

/// A chapter's program with its options. A relative --out means the person's folder; none means the course's
/// own figures/.
int run_chapter(const std::string& chapter, const Words& options) {
    Words words = {program(chapter)};
    if (!names_out(options)) words.insert(words.end(), {"--out", (source_folder / "figures").string()});
    words.insert(words.end(), options.begin(), options.end());
    return course::run_program(words);
}

int run(const course::Arguments& arguments) {
    if (arguments.rest.empty())
        throw std::invalid_argument(
            fmt::format("run which chapter? There are {}", fmt::join(chapters(), ", ")));
    const std::string chapter = chapter_named(arguments.rest.front());
    if (const int code = build({chapter}); code != 0) return code;
    return run_chapter(chapter, {arguments.rest.begin() + 1, arguments.rest.end()});
}

int list(const course::Arguments&) {
    for (const std::string& chapter : chapters()) fmt::print("{:<24}{}\n", chapter, title_of(chapter));
    return 0;
}

// ----------------------------------------------------------------------------------------- figures

constexpr std::uintmax_t published_limit = 150'000;  // bytes; a page of text shows several

/// The pictures of `chapter` that the texts show, by the names of its figures: docs/pictures/01_loops.svg is
/// loops.svg.
Words shown_pictures(const std::string& chapter) {
    std::string text = read_text(source_folder / "README.md");
    for (const std::string& name : chapters())
        text += read_text(source_folder / "chapters" / name / "README.md");

    const std::string start = "docs/pictures/" + chapter.substr(0, 3);
    Words             names;
    for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1)) {
        const std::size_t name = at + start.size();
        names.push_back(text.substr(name, text.find_first_of(")\" \n", name) - name));
    }
    return names;
}

/// Copies the pictures of `chapter` that a text shows from `figures` to docs/pictures.
void publish(const std::string& chapter, const fs::path& figures) {
    const fs::path pictures = source_folder / "docs" / "pictures";
    fs::create_directories(pictures);
    for (const std::string& name : shown_pictures(chapter)) {
        const fs::path figure = figures / chapter / name;
        if (!fs::exists(figure))
            throw std::runtime_error(
                fmt::format("a text shows {}, which {} did not make", figure.string(), chapter));
        if (fs::file_size(figure) > published_limit)
            throw std::runtime_error(
                fmt::format("{} has {} bytes, a published picture at most {}: choose a smaller --size",
                            figure.string(), fs::file_size(figure), published_limit));
        fs::copy_file(figure, pictures / (chapter.substr(0, 3) + name), fs::copy_options::overwrite_existing);
    }
}

/// Where the shared options put the figures.
fs::path out_of(const Words& shared) {
    const auto option = std::find(shared.begin(), shared.end(), "--out");
    return option == shared.end() ? source_folder / "figures" : fs::path(*(option + 1));
}

int figures(const course::Arguments& arguments) {
    Words chosen;
    for (const std::string& word : arguments.rest) chosen.push_back(chapter_named(word));
    if (chosen.empty()) chosen = chapters();
    if (const int code = build(chosen); code != 0) return code;

    int   worst = 0;
    Words failed;
    for (const std::string& chapter : chosen) {
        const int code = run_chapter(chapter, arguments.shared);
        if (code > 128) return code;  // interrupted
        if (code != 0) failed.push_back(chapter);
        worst = std::max(worst, code);
    }
    if (!failed.empty()) fmt::print(stderr, "course: failed: {}; see above\n", fmt::join(failed, ", "));
    if (worst == 0 && arguments.has("--publish"))
        for (const std::string& chapter : chosen) publish(chapter, out_of(arguments.shared));
    return worst;
}

// ---------------------------------------------------------------------------------- tests, benchmarks

int test(const course::Arguments& arguments) {
    if (const int code = build({}); code != 0) return code;
    Words words = {"ctest",
                   "--test-dir",
                   build_folder.string(),
                   "--output-on-failure",
                   "--no-tests=error",
                   "--progress",
                   "--parallel",
                   std::to_string(std::thread::hardware_concurrency())};
    if (!arguments.rest.empty())
        words.insert(words.end(), {"--tests-regex", fmt::format("{}", fmt::join(arguments.rest, "|"))});
    return course::run_program(words);
}

/// What `course bench` can measure: tests/speed/<topic>.cpp, a program, or tests/speed/<topic>.cmake, a
/// script.
std::vector<fs::path> topics() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(source_folder / "tests" / "speed"))
        if (const fs::path type = entry.path().extension(); type == ".cpp" || type == ".cmake")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// The first line of its comment that is not its name.
std::string purpose_of(const fs::path& topic) {
    return first_line_after(topic.extension() == ".cpp" ? "/// " : "# ", topic);
}

/// All of that comment: what is measured, and what the columns are.
std::string comment_of(const fs::path& topic) {
    const std::string mark = topic.extension() == ".cpp" ? "///" : "#";
    std::ifstream     file(topic);
    std::string       text;
    for (std::string line; std::getline(file, line) && line.starts_with(mark);) {
        line.erase(0, mark.size() + 1);
        if (!line.starts_with("@")) text += (text.empty() ? "" : "\n") + line;
    }
    return text;
}

int list_topics() {
    course::Rows table{{"topic", "what it measures"}};
    for (const fs::path& file : topics()) table.add({file.stem().string(), purpose_of(file)});
    course::print(table);
    return 0;
}

fs::path topic_named(const std::string& word) {
    Words known;
    for (const fs::path& file : topics()) {
        if (file.stem() == word) return file;
        known.push_back(file.stem().string());
    }
    throw std::invalid_argument(
        fmt::format("there is no benchmark '{}'; there are {}", word, fmt::join(known, ", ")));
}

int bench(const course::Arguments& arguments) {
    const auto csv = arguments.value("--csv");
    if (arguments.rest.empty() && csv)
        throw std::invalid_argument(fmt::format("bench --csv {}: name a topic, as bench lists them", *csv));
    if (arguments.rest.empty()) return list_topics();
    if (arguments.rest.size() > 1)
        throw std::invalid_argument(
            fmt::format("bench {}: one topic at a time", fmt::join(arguments.rest, " ")));
    const fs::path    file  = topic_named(arguments.rest.front());
    const std::string topic = file.stem().string();

    Words words;
    if (file.extension() == ".cpp") {
        if (const int code = build({"bench_" + topic}); code != 0) return code;
        words = {program("bench_" + topic)};
        if (csv) words.insert(words.end(), {"--csv", *csv});
    } else {
        words = {"cmake"};
        if (csv) words.push_back("-DCSV=" + fs::absolute(*csv).string());
        words.insert(words.end(), {"-P", file.string()});
    }
    return course::run_program(words);
}

// ------------------------------------------------------------------------------------ site, doctor

int docs(const course::Arguments&) {
    if (const int code = build({"docs"}); code != 0) return code;
    fmt::print("{}\n", (build_folder / "docs" / "html" / "index.html").string());
    return 0;
}

/// Looks at the packages anew: the build folder's table is as old as its last configuration.
course::Rows packages() {
    std::string said;
    const int   code = course::run_program({"cmake", build_folder.string()},
                                           [&](std::string_view line) { said += fmt::format("{}\n", line); });
    if (code != 0) fmt::print(stderr, "{}", said);
    return course::read_csv(build_folder / "packages.csv");
}

int doctor(const course::Arguments&) {
    const course::Rows table = packages();
    course::Rows       shown{{"package", "state", "version", "what for"}};
    std::string        installer, names;
    bool               can_build = true;
    for (const auto& row : table.rows) {
        const bool missing = row[table.column("state")].text() == "missing";
        shown.add({row[table.column("package")], row[table.column("state")], row[table.column("version")],
                   row[table.column("purpose")]});
        installer = row[table.column("installer")].text();
        if (const std::string name = row[table.column("name")].text(); missing && name != "-")
            names += " " + name;
        if (missing && row[table.column("need")].text() == "build") can_build = false;
    }
    course::print(shown);
    if (!names.empty()) fmt::print("\nTo install what is missing:\n    {}{}\n", installer, names);
    return can_build ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    using course::Rest;
    return course::dispatch(
        argc, argv, "course", read_text(source_folder / "common" / "course" / "help.txt"),
        {{.name         = "figures",
          .help         = "Makes the figures of all chapters, or of some.",
          .rest         = Rest::words,
          .rest_name    = "[NN...]",
          .options      = {{"--publish", "", "copy what the texts show to docs/pictures"}},
          .takes_shared = true,
          .run          = figures},
         {.name      = "run",
          .help      = "Runs a chapter's program; `run NN --help` lists its options.\n"
                       "Figures go to the course's own folder figures unless --out names another.",
          .rest      = Rest::verbatim,
          .rest_name = "NN [option...]",
          .run       = run},
         {.name      = "test",
          .help      = "Builds everything and runs the tests, or those whose names match one of the words.",
          .rest      = Rest::words,
          .rest_name = "[NAME...]",
          .run       = test},
         {.name      = "bench",
          .help      = "Measures a topic, and `bench TOPIC --help` says what; without one, lists the topics.",
          .rest      = Rest::words,
          .rest_name = "[TOPIC]",
          .options   = {{"--csv", "FILE", "write the table to FILE as well"}},
          .run       = bench,
          .help_on   = [](const Words& words) { return comment_of(topic_named(words.front())); }},
         {.name = "docs", .help = "Makes the site from the texts and the code.", .run = docs},
         {.name = "list", .help = "Lists the chapters and their titles.", .run = list},
         {.name = "doctor",
          .help = "Tells what is installed, what is missing and how to get it.",
          .run  = doctor}});
}
