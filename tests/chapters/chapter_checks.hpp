#pragma once
/// @file chapter_checks.hpp
/// What holds for every chapter, checked from outside:
///     const ChapterRuns runs("02_surfaces", "--size 64");
///     runs.check_claims({0.5});                   // 0.5 stands in the text and is given, not measured
///     runs.check_renders(10);
///     runs.check_chart("methods", speed_accuracy_columns, 12);

#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "course/csv.hpp"
#include "run_course.hpp"
#include "text_numbers.hpp"

namespace sr::test {

/// Runs a chapter's program by itself in `folder`.
inline Ended run_chapter(const std::string& chapter, const fs::path& folder, const std::string& options) {
    return run_shell(folder, "'" + (build_folder / "bin" / chapter).string() + "' " + options);
}

/// The columns with which the data of every speed/accuracy chart begins.
const inline std::vector<std::string> speed_accuracy_columns{"method", "effort", "seconds", "error",
                                                             "error_se"};

/// A chapter's program, run twice as a draft: on one thread and on seven.
class ChapterRuns {
public:
    ChapterRuns(const std::string& chapter, const std::string& options)
        : chapter_(chapter), scratch_(chapter) {
        for (const auto& [threads, out] : {std::pair{"1", "one"}, {"7", "seven"}}) {
            const Ended ended =
                run_chapter(chapter, scratch_.path,
                            "--quality draft " + options + " --threads " + threads + " --out " + out);
            INFO(ended.out << ended.err);
            CHECK(ended.code == 0);
        }
        CHECK(fs::exists(scratch_.path / "one" / "index.html"));
    }

    /// Every claim holds, whatever the number of threads; its number stands in its section of the text; and
    /// every result of the text is claimed there, or `given`.
    void check_claims(const std::set<double>& given) const {
        CHECK(read_text(folder("one") / "claims.csv") == read_text(folder("seven") / "claims.csv"));
        const course::Rows claims = course::read_csv(folder("one") / "claims.csv");
        CHECK(claims.header ==
              std::vector<std::string>{"claim", "expected", "measured", "error", "tolerance", "pass"});
        CHECK(claims.rows.size() >= 10);
        const auto sections = sections_of(read_text(source_folder / "chapters" / chapter_ / "README.md"));
        std::map<std::string, std::set<double>> claimed;  // in each section
        for (const auto& claim : claims.rows) {
            const std::string name     = claim[0].text();
            const double      expected = claim[1].number();
            INFO(name);
            CHECK(claim[5].text() == "yes");
            const std::string section = name.substr(0, name.find(' '));
            claimed[section].merge(numbers_of(name));
            claimed[section].insert(expected);
            REQUIRE(sections.contains(section));
            CHECK((expected == 0 || numbers_of(sections.at(section)).contains(expected)));
        }
        for (const auto& [section, text] : sections) {
            for (const double result : results_in(text)) {
                INFO(section << " says " << result << ", which nothing claims");
                CHECK((claimed[section].contains(result) || given.contains(result)));
            }
        }
    }

    /// So many pictures are rendered, the same for any number of threads.
    void check_renders(std::size_t count) const {
        const auto renders = renders_in(folder("one"));
        CHECK(renders.size() == 2 * count);  // .png and .hdr
        CHECK(renders == renders_in(folder("seven")));
    }

    /// A chart's data begin with these columns and have so many rows at least.
    course::Rows check_chart(const std::string& name, const std::vector<std::string>& columns,
                             int rows) const {
        INFO(name);
        const course::Rows chart = course::read_csv(folder("one") / (name + ".csv"));
        REQUIRE(chart.header.size() >= columns.size());
        CHECK(std::equal(columns.begin(), columns.end(), chart.header.begin()));
        CHECK(std::ssize(chart.rows) >= rows);
        return chart;
    }

private:
    [[nodiscard]] fs::path folder(const std::string& run) const { return scratch_.path / run / chapter_; }

    static std::map<std::string, std::string> renders_in(const fs::path& folder) {
        std::map<std::string, std::string> bytes;
        for (const auto& entry : fs::directory_iterator(folder)) {
            const auto type = entry.path().extension();
            if (type == ".hdr" || type == ".png")
                bytes[entry.path().filename().string()] = read_text(entry.path());
        }
        return bytes;
    }

    std::string   chapter_;
    ScratchFolder scratch_;
};

}  // namespace sr::test
