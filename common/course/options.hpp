#pragma once
/// @file options.hpp
/// The options that every chapter program shares, and the sub-commands of `course`. The only door to the
/// option parser: its header is slow to compile, so options.cpp alone includes it.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sr::course {

/// How much time a figure is worth: a look, a lecture, a printed page.
enum class Quality { draft, lecture, print };

/// What a number is at each quality where the person names none.
struct ByQuality {
    int draft   = 0;
    int lecture = 0;
    int print   = 0;

    [[nodiscard]] int at(Quality quality) const;
};

/// What a chapter states about its own options.
struct Defaults {
    ByQuality                size           = {.draft = 128, .lecture = 512, .print = 1024};
    std::optional<ByQuality> samples        = std::nullopt;  ///< none: the chapter takes no samples
    bool                     square_samples = false;  ///< a pixel's samples form a square: 1, 4, 9, ...
    bool                     takes_seed     = true;   ///< false: its random numbers are always the same
    std::string              scene_section  = {};  ///< that renders --scene FILE: "1.2"; none: no such option
    std::string error_section = {};  ///< that renders until --error X is reached; none: no such option

    // what --help says after "samples per" and after "start of the random numbers of"
    std::string_view sampled_each = "pixel of a render";
    std::string_view seeded       = "all that is drawn; with others claims may fail";
};

/// What the person asked for, complete and checked.
struct Options {
    std::filesystem::path                out     = "figures";  ///< the chapter's folder is made in it
    Quality                              quality = Quality::lecture;
    int                                  size    = 512;  ///< longer edge of a render [pixels], 16 to 8192
    int                                  samples = 1;    ///< per pixel or per estimate, 1 to 1'000'000
    int                                  threads = 1;    ///< 1 to 1024; all cores by default
    std::uint64_t                        seed    = 1;
    std::vector<std::string>             formats = {"svg"};       ///< of svg, png, pdf, tex
    std::optional<std::filesystem::path> scene   = std::nullopt;  ///< a file that is there
    double error = 0.2;  ///< of a render that ends when it is reached, relative to its mean; 0.001 to 1
};

/// The parsed options, or the exit code of a program that has nothing more to do: 0 after --help, 2 after
/// one line on stderr that says what was wrong.
struct Parsed {
    std::optional<Options> options   = std::nullopt;
    int                    exit_code = 0;
};

/// Reads the options of the program `name` ("01_rays") whose subject is `title`. One that is given and changes nothing
/// gets a line on stderr and is no error: `course figures` passes the same options to all chapters.
[[nodiscard]] Parsed parse_options(int argc, const char* const* argv, std::string_view name,
                                   std::string_view title, const Defaults& defaults);

/// What a command does with the words that follow it and are not its options.
enum class Rest {
    none,      ///< there are none: any word is an error
    words,     ///< words such as chapter names; an unknown option is an error
    verbatim,  ///< from the first word on everything belongs to another program: `run 01 --help`
};

/// An option of one command. `{"--csv", "FILE", "write the rows to FILE"}` takes a value,
/// `{"--publish", "", "copy ..."}` is a flag.
struct CommandOption {
    std::string name;
    std::string value;
    std::string help;
};

/// What the person gave a command.
struct Arguments {
    std::vector<std::string> rest;    ///< the words, see `Rest`
    std::vector<std::string> shared;  ///< the shared options as given: {"--size", "200"}; to pass on
    std::map<std::string, std::string>
        given;  ///< name and value (empty for a flag) of the command's own options

    [[nodiscard]] bool                       has(std::string_view name) const;    ///< has("--publish")
    [[nodiscard]] std::optional<std::string> value(std::string_view name) const;  ///< value("--csv")
};

/// A sub-command. Example, `figures [NN...] [--publish] [shared options]`:
///     {.name = "figures", .help = "make the figures", .rest = Rest::words, .rest_name = "NN",
///      .options = {{"--publish", "", "copy them to docs/pictures"}}, .takes_shared = true, .run = figures}
struct Command {
    std::string                          name;
    std::string                          help;  ///< what its --help says first
    Rest                                 rest         = Rest::none;
    std::string                          rest_name    = {};  ///< as --help shows it: "[NN...]"
    std::vector<CommandOption>           options      = {};
    bool                                 takes_shared = false;  ///< --size ... are checked here, to pass on
    std::function<int(const Arguments&)> run;

    /// What `bench rays --help` says first, where the help is that of the words; none: `help`.
    std::function<std::string(const std::vector<std::string>& words)> help_on = {};
};

/// A program that is one command: parses, calls it and returns its exit code; help and mistakes as below.
[[nodiscard]] int run_command(int argc, const char* const* argv, const Command& command);

/// Parses, calls the command and returns its exit code. No command, `help` or `--help`: `help`, exit code 0. What
/// is not known gets one line on stderr with the nearest that is, and exit code 2; so does an exception of the
/// command: `course: error: ...`.
[[nodiscard]] int dispatch(int argc, const char* const* argv, std::string_view program, std::string_view help,
                           const std::vector<Command>& commands);

}  // namespace sr::course
