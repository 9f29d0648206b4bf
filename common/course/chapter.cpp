/// @file chapter.cpp

#include "course/chapter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <stdexcept>

#include "course/draw.hpp"
#include "course/errors.hpp"
#include "course/gnuplot.hpp"
#include "course/interruptible.hpp"
#include "course/number.hpp"
#include "course/terminal.hpp"
#include "image/whole_file.hpp"
#include "image/write_image.hpp"

namespace sr::course {

namespace fs = std::filesystem;

namespace {

/// Makes the folder, and finds out before any work is done whether figures can be written there.
void prepare(const fs::path& out, const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw std::runtime_error(
            fmt::format("--out {}: cannot make {}: {}", out.string(), folder.string(), error.message()));
    const fs::path probe = folder / ".probe";
    try {
        write_whole_file(probe, "");
    } catch (const std::exception& reason) {
        throw std::runtime_error(fmt::format("--out {}: {}", out.string(), reason.what()));
    }
    fs::remove(probe, error);
}

/// A figure's name is that of its files.
void check_name(std::string_view name, const std::vector<std::string>& taken) {
    const bool plain =
        !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
    if (!plain)
        throw std::invalid_argument(fmt::format("figure {}: its name must be of a-z, 0-9 and _", name));
    if (std::find(taken.begin(), taken.end(), name) != taken.end())
        throw std::invalid_argument(fmt::format("figure {}: this name is taken", name));
}

/// A figure's data and, where gnuplot is there, its pictures.
template <class Script>
std::vector<std::string> write_drawn(const fs::path& folder, const std::string& name, const Rows& data,
                                     const std::vector<std::string>& formats, const Script& script) {
    const fs::path csv = folder / (name + ".csv");
    write_csv(csv, data);
    std::vector<std::string> files{name + ".csv"};
    for (const std::string& format : formats) {
        const std::optional<std::string> picture = run_gnuplot(script(csv, format));
        if (!picture) continue;
        files.push_back(name + "." + format);
        write_whole_file(folder / files.back(), Dialect{format}.finished(*picture));
    }
    return files;
}

void print_claims(const std::vector<Claim>& claims) {
    if (claims.empty()) return;
    const auto failed = std::count_if(claims.begin(), claims.end(), [](const Claim& c) { return !c.pass(); });
    fmt::print("\n{}", to_text(to_table(claims), claim_text));
    if (failed == 0)
        fmt::print("{}\n", emphasise(counted(std::ssize(claims), "claim") + ", all hold", Emphasis::good));
    else
        fmt::print("{}\n",
                   emphasise(fmt::format("{} of {} claims failed", failed, claims.size()), Emphasis::bad));
}

/// What an interrupt says, on a line of its own: on a terminal, "^C" and perhaps a progress stand on this one.
std::string last_words(std::string_view chapter, std::ptrdiff_t figures, const fs::path& folder) {
    const std::string where =
        figures == 0 ? "before its first figure"
                     : fmt::format("{} so far in {}", counted(figures, "figure"), folder.string());
    return fmt::format("{}{}: interrupted: {}\n", stderr_is_terminal() ? "\n" : "", chapter, where);
}

/// Says what there is, and where: charts without gnuplot are data and no more.
void print_closing(const std::vector<Figure>& figures, const fs::path& folder, const fs::path& index) {
    const auto undrawn =
        std::count_if(figures.begin(), figures.end(), [](const Figure& f) { return f.files.size() < 2; });
    const auto  drawn = std::ssize(figures) - undrawn;
    std::string what  = counted(drawn, undrawn == 0 ? "figure" : "render");
    if (undrawn != 0) what += " and the data of " + counted(undrawn, "chart");
    fmt::print("\n{} in {}, all of them in {}\n", what, folder.string(), index.string());
    if (undrawn != 0)
        fmt::print("gnuplot was not found: install it for the charts; `./course doctor` says how\n");
}

/// Gives the lecture. @return whether it came to its end, and was not interrupted
bool ends_by_itself(const Lecture& lecture, Chapter& chapter) try {
    lecture(chapter);
    return true;
} catch (const Interrupted&) {
    return false;
}

}  // namespace

Chapter::Chapter(std::string name, std::string_view title, Options options)
    : name_{std::move(name)},
      heading_{fmt::format("{} {}", std::stoi(name_), title)},
      options_{std::move(options)} {
    prepare(options_.out, folder());
    on_interrupt(folder(), last_words(name_, 0, folder()));
}

void Chapter::section(std::string_view heading) {
    const auto write_complete = [&](auto& drawings) {
        for (const auto& drawing : drawings)
            if (drawing.is_complete()) write(drawing);
        std::erase_if(drawings, [](const auto& drawing) { return drawing.is_complete(); });
    };
    write_complete(charts_);
    write_complete(diagrams_);
    fmt::print("\n{}\n", emphasise(heading, Emphasis::strong));
    std::fflush(stdout);
}

void Chapter::say(std::string_view line) {
    fmt::print("  {}\n", line);
    std::fflush(stdout);
}

void Chapter::say(const Rows& table) {
    print(table);
    std::fflush(stdout);
}

void Chapter::note(std::string_view line) {
    std::fflush(stdout);
    fmt::print(stderr, "{}: {}\n", name_, line);
}

Chart Chapter::chart(std::string name, std::string title, Axes axes) {
    take_name(name);
    return charts_.emplace_back(std::move(name), std::move(title), std::move(axes));
}

Diagram Chapter::diagram(std::string name, std::string title) {
    take_name(name);
    return diagrams_.emplace_back(std::move(name), std::move(title));
}

void Chapter::render(std::string name, std::string title, std::string caption, const Image<Spectrum>& film) {
    take_name(name);
    const std::vector<std::string> files{name + ".png", name + ".hdr"};
    write_png(folder() / files[0], film);
    write_hdr(folder() / files[1], film);
    take_figure({std::move(name), "render", std::move(title), std::move(caption), files});
}

void Chapter::claim(std::string name, Measured value) {
    claims_.push_back({std::move(name), value});
}

void Chapter::claim_at_most(std::string name, double measured, double bound) {
    claims_.push_back(at_most(std::move(name), measured, bound));
}

bool Chapter::finish() {
    for (const Chart& chart : charts_) write(chart);
    for (const Diagram& diagram : diagrams_) write(diagram);
    const auto place = [&](const Figure& figure) { return std::ranges::find(names_, figure.name); };
    std::ranges::sort(figures_, {}, place);  // as the chapter made them
    write_csv(folder() / "claims.csv", to_rows(claims_));
    write_csv(folder() / "claims_shown.csv", to_table(claims_));
    const std::vector<std::string> old = outdated(folder(), figures_);
    write_captions(folder(), heading_, figures_);
    print_claims(claims_);
    for (const std::string& left_out : write_index(options_.out)) note(left_out);
    for (const std::string& file : old) fs::remove(folder() / file);  // last: until here pages show them
    print_closing(figures_, folder(), options_.out / "index.html");
    if (!old.empty()) fmt::print("removed, as older than their data: {}\n", fmt::join(old, ", "));
    return std::all_of(claims_.begin(), claims_.end(), [](const Claim& claim) { return claim.pass(); });
}

void Chapter::take_name(const std::string& name) {
    check_name(name, names_);
    names_.push_back(name);
}

void Chapter::take_figure(Figure figure) {
    figures_.push_back(std::move(figure));
    on_interrupt(folder(), last_words(name_, std::ssize(figures_), folder()));
}

void Chapter::write(const Chart& chart) {
    const ChartData& data = chart.data();
    const auto script = [&](const auto& csv, const auto& format) { return chart_script(data, csv, format); };
    take_figure({data.name, "chart", data.title, data.caption,
                 write_drawn(folder(), data.name, grouped_by_series(data), options_.formats, script)});
}

void Chapter::write(const Diagram& diagram) {
    const DiagramData& data   = diagram.data();
    const auto         script = [&](const auto& csv, const auto& format) {
        return diagram_script(data, csv, format);
    };
    take_figure({data.name, "diagram", data.title, data.caption,
                 write_drawn(folder(), data.name, to_rows(data), options_.formats, script)});
}

int run(int argc, const char* const* argv, std::string_view name, std::string_view title,
        const Defaults& defaults, const Lecture& lecture) {
    end_cleanly_on_interrupt();
    const Parsed parsed = parse_options(argc, argv, name, title, defaults);
    if (!parsed.options) return parsed.exit_code;
    try {
        Chapter chapter{std::string{name}, title, *parsed.options};
        fmt::print("{}\n", emphasise(title, Emphasis::strong));
        const bool whole = ends_by_itself(lecture, chapter);
        const bool hold  = chapter.finish();
        std::fflush(stdout);
        if (!whole) std::raise(SIGINT);
        return hold ? 0 : claim_failed;
    } catch (const std::exception& error) {
        std::fflush(stdout);
        return report_error(name, error);
    }
}

int run(int argc, const char* const* argv, std::string_view name, std::string_view title,
        const Lecture& lecture) {
    return run(argc, argv, name, title, {}, lecture);
}

}  // namespace sr::course
