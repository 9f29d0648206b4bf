#pragma once
/// @file figures.hpp
/// The list of a chapter's figures and the page that shows all of them.

#include <filesystem>
#include <string>
#include <vector>

namespace sr::course {

/// One figure of a chapter: what it is and the files that it left.
struct Figure {
    std::string              name;
    std::string              kind;  ///< chart, diagram, render
    std::string              title;
    std::string              caption;
    std::vector<std::string> files;  ///< in the chapter's folder, the picture to look at first
};

/// Names what the captions.csv of an earlier run lists for these figures and this run did not make: another
/// format, or a chart where gnuplot is gone, would show old numbers. What no run listed is a person's own.
[[nodiscard]] std::vector<std::string> outdated(const std::filesystem::path& chapter,
                                                const std::vector<Figure>&   figures);

/// Writes `captions.csv` into the chapter's folder: chapter,figure,kind,title,caption,files.
/// @param heading   of the chapter: "1 Rays"
void write_captions(const std::filesystem::path& chapter, const std::string& heading,
                    const std::vector<Figure>& figures);

/// Writes `index.html`, one page of all chapters' figures and claims, from what their folders hold: captions.csv and
/// claims_shown.csv.
/// @return of each folder whose files are damaged, or none of ours, a line on why the page leaves it out
[[nodiscard]] std::vector<std::string> write_index(const std::filesystem::path& figures_root);

}  // namespace sr::course
