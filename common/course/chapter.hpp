#pragma once
/// @file chapter.hpp
/// What a chapter's program is written with. How to use:
///     int main(int argc, char** argv) {
///         return course::run(argc, argv, "02_surfaces", "Surfaces", [](course::Chapter& chapter) {
///             planes(chapter);
///             spheres(chapter);
///         });
///     }

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "course/chart.hpp"
#include "course/claim.hpp"
#include "course/diagram.hpp"
#include "course/figures.hpp"
#include "course/options.hpp"
#include "course/progress.hpp"
#include "course/table.hpp"
#include "course/timing.hpp"
#include "image/image.hpp"
#include "radiometry/spectrum.hpp"

namespace sr::course {

/// A chapter in progress: what the person asked for, and what has been said, charted and claimed so far.
class Chapter {
public:
    /// @param name   of its program and of its folder, the number first: "01_rays"
    /// @param title  "Rays"
    Chapter(std::string name, std::string_view title, Options options);

    [[nodiscard]] const Options& options() const { return options_; }

    /// Where this chapter's figures are written; exists.
    [[nodiscard]] std::filesystem::path folder() const { return options_.out / name_; }

    /// "1.2 The image plane", on stdout. Writes the charts and diagrams that nobody fills any more.
    void section(std::string_view heading);
    void say(std::string_view line);  ///< a fact that is no claim, such as a time
    void say(const Rows& table);      ///< a small table, aligned

    /// One line on stderr of what is no error, but perhaps not what the person wanted: "01_rays: ...".
    void note(std::string_view line);

    /// A chart or diagram to fill; written when its section ends.
    [[nodiscard]] Chart   chart(std::string name, std::string title, Axes axes);
    [[nodiscard]] Diagram diagram(std::string name, std::string title);

    /// Writes NAME.png for looking and NAME.hdr for measuring. Title and caption are TeX.
    void render(std::string name, std::string title, std::string caption, const Image<Spectrum>& film);

    /// |measured - expected| <= tolerance, or the program exits with 1.
    void claim(std::string name, Measured value);
    /// measured <= bound, or the program exits with 1.
    void claim_at_most(std::string name, double measured, double bound);

    /// Writes what is charted and claimed and prints the claims. @return whether all of them hold
    [[nodiscard]] bool finish();

private:
    void take_name(const std::string& name);
    void take_figure(Figure figure);
    void write(const Chart& chart);
    void write(const Diagram& diagram);

    std::string              name_;
    std::string              heading_;  ///< "1 Rays"
    Options                  options_;
    std::vector<Chart>       charts_;
    std::vector<Diagram>     diagrams_;
    std::vector<Figure>      figures_;
    std::vector<Claim>       claims_;
    std::vector<std::string> names_;  ///< of all figures, each its own file
};

using Lecture = std::function<void(Chapter&)>;

/// Runs a chapter's program from its options to its table of claims.
/// @return the exit code: 0, 1 when a claim failed, 2 after one line on stderr that says what was wrong. After an
///         interrupt, also one that the lecture saw and passes on as Interrupted, the program ends with 130
[[nodiscard]] int run(int argc, const char* const* argv, std::string_view name, std::string_view title,
                      const Defaults& defaults, const Lecture& lecture);
[[nodiscard]] int run(int argc, const char* const* argv, std::string_view name, std::string_view title,
                      const Lecture& lecture);

}  // namespace sr::course
