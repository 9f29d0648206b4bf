/// @file figures.cpp

#include "course/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <stdexcept>

#include "course/claim.hpp"
#include "course/csv.hpp"
#include "course/tex.hpp"
#include "image/whole_file.hpp"

namespace sr::course {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view captions_file = "captions.csv";
constexpr std::string_view claims_file   = "claims_shown.csv";

constexpr std::string_view page_head = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Steradian: figures</title>
<style>
  body { font: 16px/1.5 system-ui, sans-serif; color: #222; background: #fff; margin: 2rem auto; max-width: 90rem; padding: 0 1.5rem; }
  nav a { margin-right: 1.2rem; }
  a { color: #0072b2; }
  section { margin-top: 3rem; }
  .grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(26rem, 100%), 1fr)); gap: 2rem; }
  figure { margin: 0; border: 1px solid #ddd; border-radius: 6px; padding: 1rem; }
  figure img { display: block; width: 100%; max-height: 26rem; object-fit: contain; background: #fff; }
  figcaption p { margin: .4rem 0; }
  .files { font-size: .85em; }
  .files a { margin-right: .8rem; }
  .claims { overflow-x: auto; }
  table { border-collapse: collapse; margin-top: 1.5rem; font-variant-numeric: tabular-nums; }
  th, td { padding: .25rem .8rem; border-bottom: 1px solid #ddd; text-align: right; }
  th:first-child, td:first-child { text-align: left; }
  .yes { color: #00845f; } .no { color: #d55e00; font-weight: bold; }
</style>
<h1>Figures</h1>
)";

/// Text that is no TeX.
std::string html(std::string_view text) {
    std::string safe;
    for (const char c : text)
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '"')
            safe += "&quot;";
        else
            safe += c;
    return safe;
}

bool can_be_shown(const std::string& file) {
    return file.ends_with(".svg") || file.ends_with(".png");
}

std::string card(const std::string& chapter, const Figure& figure) {
    const auto  picture = std::find_if(figure.files.begin(), figure.files.end(), can_be_shown);
    std::string card    = "<figure>\n";
    if (picture != figure.files.end())
        card += fmt::format("<a href=\"{0}/{1}\"><img src=\"{0}/{1}\" alt=\"{2}\" loading=\"lazy\"></a>\n",
                            html(chapter), html(*picture), html(tex_to_plain(figure.title)));
    card += fmt::format("<figcaption><p><strong>{}</strong></p>\n", tex_to_html(figure.title));
    if (!figure.caption.empty()) card += fmt::format("<p>{}</p>\n", tex_to_html(figure.caption));
    card += "<p class=\"files\">";
    for (const std::string& file : figure.files)
        card += fmt::format("<a href=\"{}/{}\">{}</a>", html(chapter), html(file), html(file));
    return card + "</p></figcaption>\n</figure>\n";
}

std::string claims_table(const fs::path& csv) {
    if (!fs::exists(csv)) return "";
    const Rows claims = read_csv(csv);
    if (claims.header != to_rows({}).header)
        throw std::runtime_error(fmt::format("{} is no table of claims", csv.string()));
    std::string table = "<div class=\"claims\"><table>\n<tr>";
    for (const std::string& header : claims.header) table += fmt::format("<th>{}</th>", html(header));
    table += "</tr>\n";
    for (const auto& row : claims.rows) {
        table += "<tr>";
        for (std::size_t column = 0; column < row.size(); ++column) {
            const std::string text = claim_text(row, column);
            const bool        pass = column + 1 == row.size();
            table += fmt::format("<td{}>{}</td>", pass ? fmt::format(" class=\"{}\"", html(text)) : "",
                                 html(text));
        }
        table += "</tr>\n";
    }
    return claims.rows.empty() ? "" : table + "</table></div>\n";
}

std::vector<Figure> figures_of(const Rows& captions) {
    std::vector<Figure> figures;
    for (const auto& row : captions.rows) {
        const auto  text = [&](std::string_view column) { return row[captions.column(column)].text(); };
        Figure      figure{text("figure"), text("kind"), text("title"), text("caption"), {}};
        std::string files = text("files") + " ";
        for (std::size_t space; (space = files.find(' ')) != std::string::npos; files.erase(0, space + 1))
            figure.files.push_back(files.substr(0, space));
        figures.push_back(std::move(figure));
    }
    return figures;
}

/// What an earlier run listed; nothing where that can't be read, as the list is about to be replaced.
std::vector<Figure> listed_before(const fs::path& csv) try {
    return fs::exists(csv) ? figures_of(read_csv(csv)) : std::vector<Figure>{};
} catch (const std::exception&) {
    return {};
}

/// What the page shows of a chapter.
struct Section {
    std::string heading;
    std::string body;
};

Section section_of(const fs::path& folder) {
    const std::string chapter  = folder.filename().string();
    const Rows        captions = read_csv(folder / captions_file);
    const std::size_t headings = captions.column("chapter");
    Section           section{captions.rows.empty() ? chapter : captions.rows.front()[headings].text(), ""};
    for (const Figure& figure : figures_of(captions)) section.body += card(chapter, figure);
    section.body =
        fmt::format("<div class=\"grid\">\n{}</div>\n{}", section.body, claims_table(folder / claims_file));
    return section;
}

/// The folders that hold captions, in order.
std::vector<fs::path> chapters_in(const fs::path& figures_root) {
    std::vector<fs::path> chapters;
    for (const auto& entry : fs::directory_iterator(figures_root)) {
        std::error_code locked;  // a folder that is none of ours
        if (fs::exists(entry.path() / captions_file, locked)) chapters.push_back(entry.path());
    }
    std::sort(chapters.begin(), chapters.end());
    return chapters;
}

}  // namespace

std::vector<std::string> outdated(const fs::path& chapter, const std::vector<Figure>& figures) {
    std::vector<std::string> names;
    for (const Figure& old : listed_before(chapter / captions_file)) {
        const auto remade = std::find_if(figures.begin(), figures.end(),
                                         [&](const Figure& figure) { return figure.name == old.name; });
        if (remade == figures.end()) continue;
        for (const std::string& file : old.files) {
            const bool in_folder = fs::path(file).filename() == file && fs::is_regular_file(chapter / file);
            if (in_folder &&
                std::find(remade->files.begin(), remade->files.end(), file) == remade->files.end())
                names.push_back(file);
        }
    }
    return names;
}

void write_captions(const fs::path& chapter, const std::string& heading, const std::vector<Figure>& figures) {
    Rows table{{"chapter", "figure", "kind", "title", "caption", "files"}};
    for (const Figure& figure : figures)
        table.add({heading, figure.name, figure.kind, figure.title, figure.caption,
                   fmt::format("{}", fmt::join(figure.files, " "))});
    write_csv(chapter / captions_file, table);
}

std::vector<std::string> write_index(const fs::path& figures_root) {
    std::string              links, sections;
    std::vector<std::string> left_out;
    for (const fs::path& folder : chapters_in(figures_root)) {
        const std::string id = html(folder.filename().string());
        try {
            const auto [heading, body] = section_of(folder);
            links += fmt::format("<a href=\"#{}\">{}</a>", id, html(heading));
            sections +=
                fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", id, html(heading), body);
        } catch (const std::exception& error) {
            left_out.push_back(fmt::format("index.html leaves out {}: {}", folder.string(), error.what()));
        }
    }
    write_whole_file(figures_root / "index.html",
                     fmt::format("{}<nav>{}</nav>\n{}</html>\n", page_head, links, sections));
    return left_out;
}

}  // namespace sr::course
