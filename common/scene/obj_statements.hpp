#pragma once
/// @file obj_statements.hpp
/// The grammar that OBJ and MTL files share: a statement a line, words between blanks.

#include <algorithm>
#include <string_view>
#include <vector>

namespace sr {

/// A statement and where it starts, counted from line 1. The words point into the text.
struct Statement {
    int                           line = 0;
    std::vector<std::string_view> words;
};

/// Adds the words of a line up to its comment.
/// @return whether a backslash at the end asks to go on with the next line. One in a comment doesn't: there
///         it ends a Windows path.
inline bool append_words(std::string_view line, std::vector<std::string_view>& words) {
    constexpr std::string_view blanks = " \t\v\f\r";
    for (;;) {
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        if (line.empty() || line.front() == '#') return false;
        if (line.front() == '\\' && line.find_first_not_of(blanks, 1) == std::string_view::npos) return true;

        std::string_view word = line.substr(0, line.find_first_of(blanks));
        const bool       last = line.find_first_not_of(blanks, word.size()) == std::string_view::npos;
        line.remove_prefix(word.size());
        const bool continued = last && word.back() == '\\';
        if (continued) word.remove_suffix(1);
        words.push_back(word);
        if (continued) return true;
    }
}

/// Calls visit(statement) for each that is not empty. Lines may end in LF or CR LF.
template <class Visit>
void for_each_statement(std::string_view text, Visit visit) {
    Statement statement;
    bool      continued = false;
    for (int line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (!continued) {
            statement.line = line;
            statement.words.clear();
        }
        continued = append_words(text.substr(0, end), statement.words);
        text.remove_prefix(std::min(end + 1, text.size()));
        if ((!continued || text.empty()) && !statement.words.empty()) visit(statement);
    }
}

}  // namespace sr
