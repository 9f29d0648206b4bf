/// @file options.cpp

#include "course/options.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "course/errors.hpp"
#include "course/table.hpp"

namespace sr::course {

namespace {

using Values = std::map<std::string, std::string>;

/// The error of a render that ends by it, where the person names none.
double error_at(Quality quality) {
    return quality == Quality::draft ? 0.4 : quality == Quality::lecture ? 0.2 : 0.1;
}

int cores() {
    return std::max(1, int(std::thread::hardware_concurrency()));
}

// Why an option changes nothing.
constexpr std::string_view no_samples = "this chapter takes no samples";
constexpr std::string_view no_seed    = "this chapter always draws the random numbers of its text";

/// @param chapter   whose defaults --help shows; none: they differ from chapter to chapter
std::vector<CommandOption> shared_options(const std::optional<Defaults>& chapter) {
    const auto by_quality = [&](const ByQuality& n) {
        return fmt::format("[{} draft, {} lecture, {} print]", n.draft, n.lecture, n.print);
    };
    std::string size = "longer edge of a render in pixels ";
    std::string samples =
        fmt::format("samples per {} ", chapter ? chapter->sampled_each : "pixel or estimate");
    std::string seed =
        fmt::format("start of the random numbers of {} [1]", chapter.value_or(Defaults{}).seeded);
    size += chapter ? by_quality(chapter->size) : "[the chapter's]";
    samples += chapter && chapter->samples ? by_quality(*chapter->samples) : "[the chapter's]";
    if (chapter && !chapter->samples) samples = fmt::format("fixed: {}", no_samples);
    if (chapter && !chapter->takes_seed) seed = fmt::format("fixed: {}", no_seed);
    std::vector<CommandOption> all{
        {"--out", "DIR", "folder of the figures [figures; with course: its own folder figures]"},
        {"--quality", "Q", "draft, lecture or print [lecture]"},
        {"--size", "N", size},
        {"--samples", "N", samples},
        {"--threads", "N", fmt::format("threads to use [all cores: {}]", cores())},
        {"--seed", "N", seed},
        {"--format", "LIST", "of svg, png, pdf, tex, separated by commas [svg]"}};
    if (chapter && !chapter->scene_section.empty())
        all.push_back({"--scene", "FILE",
                       fmt::format("OBJ file: section {} renders it, the others keep their own scenes",
                                   chapter->scene_section)});
    if (chapter && !chapter->error_section.empty())
        all.push_back(
            {"--error", "X",
             fmt::format("standard error at which the render of section {} is done, as a share of its "
                         "mean [{} draft, {} lecture, {} print]",
                         chapter->error_section, error_at(Quality::draft), error_at(Quality::lecture),
                         error_at(Quality::print))});
    return all;
}

/// The value of an option as a number from `min` to `max`, a whole one if these are; `rule` says so in the error.
template <class Number>
Number number_of(const std::string& option, const std::string& text, Number min, Number max,
                 std::string_view rule) {
    Number      number{};
    const char* end             = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || stopped != end || !(min <= number && number <= max))
        throw std::invalid_argument(fmt::format("{} {}: {}", option, text, rule));
    return number;
}

void check_square(int samples) {
    const int side = int(std::sqrt(samples));
    if (side * side != samples)
        throw std::invalid_argument(
            fmt::format("--samples {}: a pixel's samples form a square here; the nearest are {} and {}",
                        samples, side * side, (side + 1) * (side + 1)));
}

Quality quality(const std::string& text) {
    if (text == "draft") return Quality::draft;
    if (text == "lecture") return Quality::lecture;
    if (text == "print") return Quality::print;
    throw std::invalid_argument(
        fmt::format("--quality {}: the quality must be draft, lecture or print", text));
}

std::vector<std::string> formats(const std::string& text) {
    const std::vector<std::string> known{"svg", "png", "pdf", "tex"};
    std::vector<std::string>       chosen;
    std::istringstream             list{text + ","};
    for (std::string format; std::getline(list, format, ',');) {
        if (std::find(known.begin(), known.end(), format) == known.end())
            throw std::invalid_argument(fmt::format(
                "--format {}: the formats must be of svg, png, pdf, tex, separated by commas", text));
        if (std::find(chosen.begin(), chosen.end(), format) == chosen.end()) chosen.push_back(format);
    }
    return chosen;
}

/// The file, which is looked for before any work is done.
std::filesystem::path scene_file(const std::string& text) {
    std::error_code ignored;
    const auto      status = std::filesystem::status(text, ignored);
    if (!exists(status))
        throw std::invalid_argument(fmt::format("--scene {}: no such file; must be an OBJ file", text));
    if (!is_regular_file(status))
        throw std::invalid_argument(fmt::format("--scene {}: is no regular file; must be an OBJ file", text));
    return text;
}

Options checked(const Values& given, const Defaults& defaults) {
    const auto value = [&](const char* name, const std::string& otherwise) {
        const auto found = given.find(name);
        return found == given.end() ? otherwise : found->second;
    };
    Options o;
    o.out             = value("--out", "figures");
    o.quality         = quality(value("--quality", "lecture"));
    const int samples = defaults.samples ? defaults.samples->at(o.quality) : o.samples;
    o.size    = number_of("--size", value("--size", std::to_string(defaults.size.at(o.quality))), 16, 8192,
                          "the image's edge must be 16 to 8192 pixels");
    o.samples = number_of("--samples", value("--samples", std::to_string(samples)), 1, 1'000'000,
                          "the number of samples must be 1 to 1000000");
    if (defaults.square_samples) check_square(o.samples);
    o.threads = number_of("--threads", value("--threads", std::to_string(cores())), 1, 1024,
                          "the number of threads must be 1 to 1024");
    o.seed    = number_of("--seed", value("--seed", "1"), std::uint64_t{0}, ~std::uint64_t{0},
                          "the seed must be a whole number from 0 to 18446744073709551615");
    o.formats = formats(value("--format", "svg"));
    o.error   = number_of("--error", value("--error", fmt::format("{}", error_at(o.quality))), 0.001, 1.0,
                          "the error must be 0.001 to 1, a share of the mean: 0.05 is 5 %");
    if (given.contains("--scene")) o.scene = scene_file(given.at("--scene"));
    return o;
}

/// One line on stderr for each option that was given and changes nothing.
void note_unused(std::string_view name, const Values& given, const Defaults& defaults) {
    const auto note = [&](const char* option, std::string_view why) {
        if (given.contains(option))
            fmt::print(stderr, "{}: {} {} changes nothing: {}\n", name, option, given.at(option), why);
    };
    if (!defaults.samples) note("--samples", no_samples);
    if (!defaults.takes_seed) note("--seed", no_seed);
}

/// A command line taken apart; of its values no more is known than that none is empty, or the next option.
struct Parts {
    Values                   values;  ///< of the known options that were given
    std::vector<std::string> rest;
    bool                     help = false;
};

/// @param what  "must follow"
[[noreturn]] void refuse_value(const CommandOption& option, std::string_view given, std::string_view what) {
    const std::string right = option.help.substr(0, option.help.find(" ["));  // the default is no help here
    throw std::invalid_argument(
        fmt::format("{}{}: {} {}: {}", option.name, given, option.value, what, right));
}

/// @pre argv[0] is the program or the command
Parts take_apart(int argc, const char* const* argv, const std::vector<CommandOption>& known, bool verbatim) {
    CLI::App app;
    Parts    parts;
    Values   texts;
    app.set_help_flag("-h,--help");
    app.allow_extras();
    app.prefix_command(verbatim);
    for (const CommandOption& option : known)
        if (option.value.empty())
            app.add_flag(option.name);
        else
            app.add_option(option.name, texts[option.name])->take_last();
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        parts.help = true;
        parts.rest = app.remaining();
        return parts;
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string message = error.what();  // "--size: ..."
        for (const CommandOption& option : known)
            if (message.starts_with(option.name + ":")) refuse_value(option, "", "must follow");
        throw;
    }
    for (const CommandOption& option : known) {
        if (app.count(option.name) == 0) continue;
        const std::string& value = parts.values[option.name] = texts[option.name];
        if (value.starts_with("--")) refuse_value(option, "", "must follow");  // and not the next option
        if (!option.value.empty() && value.empty()) refuse_value(option, " ''", "must not be empty");
    }
    parts.rest = app.remaining();
    return parts;
}

bool is_option(const std::string& word) {
    return word.size() > 1 && word.front() == '-';
}

[[noreturn]] void unknown_word(const std::string& word, const std::vector<CommandOption>& known) {
    std::vector<std::string> names{"--help"};
    for (const CommandOption& option : known) names.push_back(option.name);
    const std::string name = word.substr(0, word.find('='));
    if (name == "--scene")
        throw std::invalid_argument(
            "--scene: for the program of a chapter that renders a file: "
            "course run 01 --scene FILE");
    if (name == "--error")
        throw std::invalid_argument(
            "--error: for the program of a chapter that renders to an error: "
            "course run 10 --error 0.05");
    throw std::invalid_argument(fmt::format("{}: unknown {}{}; see --help", name,
                                            is_option(word) ? "option" : "word", did_you_mean(name, names)));
}

void print_help(std::string_view usage, std::string_view about, const std::vector<CommandOption>& options) {
    Rows rows{{"option", "what it does"}};
    for (const CommandOption& option : options)
        rows.add({option.name + (option.value.empty() ? "" : " " + option.value), option.help});
    rows.add({"--help", "this help"});
    fmt::print("{}\n\nusage: {}\n\n{}", about, usage, to_text(rows));
}

/// The words of a command, as far as its kind of rest allows them.
void check_rest(const Command& command, const std::vector<CommandOption>& known,
                const std::vector<std::string>& rest) {
    if (rest.empty()) return;
    if (command.rest == Rest::none || is_option(rest.front())) unknown_word(rest.front(), known);
    if (command.rest == Rest::verbatim) return;
    const auto option = std::find_if(rest.begin(), rest.end(), is_option);
    if (option != rest.end()) unknown_word(*option, known);
}

/// @param usage   the words that start it: "course bench"
int parse_and_call(int argc, const char* const* argv, std::string usage, const Command& command) {
    std::vector<CommandOption>       known = command.options;
    const std::vector<CommandOption> shared =
        command.takes_shared ? shared_options(std::nullopt) : decltype(known){};
    known.insert(known.end(), shared.begin(), shared.end());

    const Parts parts = take_apart(argc, argv, known, command.rest == Rest::verbatim);
    if (parts.help) {
        if (!command.rest_name.empty()) usage += " " + command.rest_name;
        if (!known.empty()) usage += " [option...]";
        const bool of_words = command.help_on && !parts.rest.empty();
        print_help(usage, of_words ? command.help_on(parts.rest) : command.help, known);
        return 0;
    }
    check_rest(command, known, parts.rest);
    if (command.takes_shared) (void)checked(parts.values, {});  // a mistake is told before anything is built

    Arguments arguments{.rest = parts.rest, .shared = {}, .given = parts.values};
    for (const CommandOption& option : shared)
        if (arguments.has(option.name)) {
            arguments.shared.insert(arguments.shared.end(), {option.name, arguments.given.at(option.name)});
            arguments.given.erase(option.name);
        }
    return command.run(arguments);
}

}  // namespace

int ByQuality::at(Quality quality) const {
    return quality == Quality::draft ? draft : quality == Quality::lecture ? lecture : print;
}

Parsed parse_options(int argc, const char* const* argv, std::string_view name, std::string_view title,
                     const Defaults& defaults) {
    const std::vector<CommandOption> known = shared_options(defaults);
    try {
        const Parts parts = take_apart(argc, argv, known, false);
        if (parts.help) {
            print_help(fmt::format("{} [option...]", name), fmt::format("{}: {}", name, title), known);
            return {};
        }
        if (!parts.rest.empty()) unknown_word(parts.rest.front(), known);
        const Options options = checked(parts.values, defaults);
        note_unused(name, parts.values, defaults);
        return {.options = options};
    } catch (const std::exception& error) {
        return {.exit_code = report_error(name, error)};
    }
}

bool Arguments::has(std::string_view name) const {
    return given.contains(std::string(name));
}

std::optional<std::string> Arguments::value(std::string_view name) const {
    const auto found = given.find(std::string(name));
    return found == given.end() ? std::nullopt : std::optional{found->second};
}

int run_command(int argc, const char* const* argv, const Command& command) try {
    return parse_and_call(argc, argv, command.name, command);
} catch (const std::exception& error) {
    return report_error(command.name, error);
}

int dispatch(int argc, const char* const* argv, std::string_view program, std::string_view help,
             const std::vector<Command>& commands) try {
    const std::string name = argc > 1 ? argv[1] : "--help";
    if (name == "--help" || name == "-h" || name == "help") {
        fmt::print("{}", help);
        return 0;
    }
    std::vector<std::string> names;
    for (const Command& command : commands) {
        if (command.name == name)
            return parse_and_call(argc - 1, argv + 1, fmt::format("{} {}", program, name), command);
        names.push_back(command.name);
    }
    throw std::invalid_argument(
        fmt::format("{}: unknown command{}; see {} --help", name, did_you_mean(name, names), program));
} catch (const std::exception& error) {
    return report_error(program, error);
}

}  // namespace sr::course
