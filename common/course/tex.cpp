/// @file tex.cpp

#include "course/tex.hpp"

#include <fmt/core.h>

#include <array>
#include <map>
#include <stdexcept>
#include <vector>

#include "course/terminal.hpp"

namespace sr::course {

namespace {

constexpr std::string_view thin_space = "\u2009";
constexpr std::string_view hard_space = "\u00a0";

/// A formula in the few shapes that all pictures know.
struct Piece {
    enum class Kind { upright, italic, bold, subscript, superscript };

    Kind               kind;
    std::string        text   = {};  ///< of the first three
    std::vector<Piece> inside = {};  ///< of the last two
};
using Kind   = Piece::Kind;
using Pieces = std::vector<Piece>;
using Texts  = std::map<std::string_view, std::string_view>;

// clang-format off
const Texts letters{
    {"alpha", "α"}, {"beta", "β"}, {"gamma", "γ"}, {"delta", "δ"}, {"epsilon", "ϵ"}, {"varepsilon", "ε"}, {"zeta", "ζ"},
    {"eta", "η"}, {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"}, {"nu", "ν"}, {"xi", "ξ"}, {"pi", "π"},
    {"rho", "ρ"}, {"sigma", "σ"}, {"tau", "τ"}, {"phi", "ϕ"}, {"varphi", "φ"}, {"chi", "χ"}, {"psi", "ψ"},
    {"omega", "ω"}, {"ell", "ℓ"}};
const Texts symbols{
    {"Gamma", "Γ"}, {"Delta", "Δ"}, {"Theta", "Θ"}, {"Lambda", "Λ"}, {"Sigma", "Σ"}, {"Phi", "Φ"}, {"Psi", "Ψ"},
    {"Omega", "Ω"}, {"infty", "∞"}, {"partial", "∂"}, {"nabla", "∇"}, {"int", "∫"}, {"sum", "∑"}, {"circ", "°"},
    {"cdot", "\u2009·\u2009"}, {"ldots", "…"}, {"perp", "⊥"}, {"langle", "⟨"}, {"rangle", "⟩"}, {",", thin_space}, {";", hard_space}, {" ", hard_space},
    {"quad", "\u00a0\u00a0"}, {"!", ""}, {"{", "{"}, {"}", "}"}, {"|", "‖"}, {"%", "%"}, {"_", "_"}, {"&", "&"}, {"#", "#"},
    {"$", "$"}, {"left", ""}, {"right", ""}};
const Texts operators{
    {"+", "+"}, {"-", "−"}, {"=", "="}, {"<", "<"}, {">", ">"}, {"times", "×"}, {"pm", "±"}, {"le", "≤"},
    {"leq", "≤"}, {"ge", "≥"}, {"geq", "≥"}, {"ll", "≪"}, {"gg", "≫"}, {"ne", "≠"}, {"neq", "≠"}, {"approx", "≈"},
    {"sim", "∼"}, {"propto", "∝"}, {"in", "∈"}, {"to", "→"}, {"rightarrow", "→"}};
const Texts accents{{"hat", "\u0302"}, {"bar", "\u0304"}, {"tilde", "\u0303"}, {"vec", "\u20d7"}, {"dot", "\u0307"}};
// clang-format on
constexpr std::array                   functions{"min", "max", "sin", "cos", "tan", "log", "ln", "exp"};
const std::map<std::string_view, Kind> faces{
    {"mathbf", Kind::bold}, {"mathrm", Kind::upright}, {"text", Kind::upright}, {"mathit", Kind::italic}};

/// Adds `text`, to the last piece where that looks the same.
void add(Pieces& pieces, Kind kind, std::string_view text) {
    if (!pieces.empty() && pieces.back().kind == kind)
        pieces.back().text += text;
    else if (!text.empty())
        pieces.push_back({kind, std::string{text}});
}

void add(Pieces& pieces, const Pieces& more) {
    for (const Piece& piece : more)
        if (piece.inside.empty())
            add(pieces, piece.kind, piece.text);
        else
            pieces.push_back(piece);
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Reads what stands between two dollar signs.
class FormulaReader {
public:
    explicit FormulaReader(std::string_view formula) : whole_{formula}, rest_{formula} {}

    Pieces all() {
        const Pieces pieces = sequence(false);
        if (!rest_.empty()) fail("a } that closes nothing");
        return pieces;
    }

private:
    /// Up to the end or the } of the group; operators have spaces around them, except in scripts.
    Pieces sequence(bool script) {
        Pieces pieces;
        while (!rest_.empty() && rest_.front() != '}') step(pieces, script);
        return pieces;
    }

    /// {group} or a single token.
    Pieces argument(bool script) {
        skip_spaces();
        Pieces pieces;
        if (rest_.empty()) fail("something must follow at its end");
        if (rest_.front() != '{') {
            step(pieces, true);
            return pieces;
        }
        rest_.remove_prefix(1);
        pieces = sequence(script);
        if (rest_.empty()) fail("a { is not closed");
        rest_.remove_prefix(1);
        return pieces;
    }

    void step(Pieces& pieces, bool script) {
        const char c = rest_.front();
        if (c == '\\') return command(pieces, script, command_name());
        if (c == '{') return add(pieces, argument(script));
        const std::string_view character = code_point();
        if (operators.contains(character)) return operation(pieces, script, operators.at(character));
        if (c == '_') return pieces.push_back({Kind::subscript, "", argument(true)});
        if (c == '^') return pieces.push_back({Kind::superscript, "", argument(true)});
        if (c == '\'') return add(pieces, Kind::upright, "′");
        if (c == '~') return add(pieces, Kind::upright, hard_space);
        if (c != ' ') add(pieces, is_letter(c) ? Kind::italic : Kind::upright, character);
    }

    void command(Pieces& pieces, bool script, std::string_view name) {
        if (letters.contains(name)) return add(pieces, Kind::italic, letters.at(name));
        if (symbols.contains(name)) return add(pieces, Kind::upright, symbols.at(name));
        if (operators.contains(name)) return operation(pieces, script, operators.at(name));
        if (faces.contains(name)) return add(pieces, faces.at(name), verbatim_argument(name == "text"));
        if (accents.contains(name)) {
            Pieces accented = argument(script);
            if (accented.empty() || accented.back().text.empty()) fail("an accent needs a letter");
            accented.back().text += accents.at(name);
            return add(pieces, accented);
        }
        if (name == "frac") {
            add(pieces, argument(script));
            add(pieces, Kind::upright, "/");
            return add(pieces, argument(script));
        }
        if (name == "sqrt") {
            add(pieces, Kind::upright, "√(");
            add(pieces, argument(script));
            return add(pieces, Kind::upright, ")");
        }
        for (const std::string_view function : functions)
            if (name == function) return add_function(pieces, name);
        fail(fmt::format("\\{} is not known", name));
    }

    void add_function(Pieces& pieces, std::string_view name) {
        add(pieces, Kind::upright, name);
        skip_spaces();
        const bool letter_follows = !rest_.empty() && (is_letter(rest_.front()) || rest_.front() == '\\');
        if (letter_follows) add(pieces, Kind::upright, thin_space);
    }

    /// A sign at the start of a formula or after another operator belongs to the number that follows.
    void operation(Pieces& pieces, bool script, std::string_view symbol) {
        const bool first = pieces.empty() ||
                           (pieces.back().kind == Kind::upright &&
                            (pieces.back().text.ends_with(hard_space) || pieces.back().text.ends_with('(')));
        const bool spaced = !script && !first;
        add(pieces, Kind::upright,
            spaced ? fmt::format("{}{}{}", hard_space, symbol, hard_space) : std::string{symbol});
    }

    /// The argument of \mathbf and its like: letters that keep their face; \text keeps its spaces as well.
    std::string verbatim_argument(bool keep_spaces) {
        const std::string_view before = rest_;
        const Pieces           pieces = argument(true);
        if (keep_spaces && before.front() == '{')
            return std::string{before.substr(1, before.size() - rest_.size() - 2)};
        std::string text;
        for (const Piece& piece : pieces) text += piece.text;
        return text;
    }

    std::string_view command_name() {
        rest_.remove_prefix(1);
        std::size_t length = 0;
        while (length < rest_.size() && is_letter(rest_[length])) ++length;
        if (length == 0 && !rest_.empty()) length = 1;
        return take(length);
    }

    std::string_view code_point() {
        std::size_t length = 1;
        while (length < rest_.size() && (static_cast<unsigned char>(rest_[length]) & 0xC0) == 0x80) ++length;
        return take(length);
    }

    std::string_view take(std::size_t length) {
        const std::string_view taken = rest_.substr(0, length);
        rest_.remove_prefix(length);
        return taken;
    }

    void skip_spaces() {
        while (rest_.starts_with(' ')) rest_.remove_prefix(1);
    }

    [[noreturn]] void fail(std::string_view what) const {
        throw std::invalid_argument(fmt::format("${}$: {}", whole_, what));
    }

    std::string_view whole_;
    std::string_view rest_;
};

/// A stretch of a label: text as it is, or what stands between two dollar signs.
struct Stretch {
    bool        formula = false;
    std::string text    = {};
};

std::vector<Stretch> stretches(std::string_view tex) {
    std::vector<Stretch> all(1);
    for (std::size_t i = 0; i < tex.size(); ++i) {
        if (tex[i] == '\\' && i + 1 < tex.size() && (tex[i + 1] == '$' || all.back().formula)) {
            if (all.back().formula) all.back().text += tex[i];
            all.back().text += tex[++i];
        } else if (tex[i] == '$') {
            all.push_back({!all.back().formula});
        } else {
            all.back().text += tex[i];
        }
    }
    if (all.back().formula) throw std::invalid_argument(fmt::format("{}: a $ is not closed", tex));
    return all;
}

Pieces read(std::string_view tex) {
    Pieces pieces;
    for (const Stretch& stretch : stretches(tex)) {
        if (stretch.formula)
            add(pieces, FormulaReader{stretch.text}.all());
        else
            add(pieces, Kind::upright, stretch.text);
    }
    return pieces;
}

/// How a kind of picture writes the pieces.
struct Writer {
    std::string (*text)(std::string_view);
    std::array<std::string_view, 5> open;  ///< before upright, italic, bold, subscript, superscript
    std::array<std::string_view, 5> close;
    std::string_view                above  = {};  ///< before a script that shares its place with the next one
    std::string_view                second = {};  ///< at the start of the latter of two scripts
};

bool is_script(const Piece& piece) {
    return piece.kind == Kind::subscript || piece.kind == Kind::superscript;
}

/// Of one character: gnuplot only guesses how wide a script is, and for longer ones too badly.
bool is_short(const Piece& script) {
    return script.inside.size() == 1 && width(script.inside.front().text) == 1;
}

std::string write(const Pieces& pieces, const Writer& writer) {
    std::string written;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece&      piece = pieces[i];
        const auto        kind  = std::size_t(piece.kind);
        const std::string inside =
            piece.inside.empty() ? writer.text(piece.text) : write(piece.inside, writer);
        const bool first  = is_script(piece) && i + 1 < pieces.size() && is_script(pieces[i + 1]);
        const bool second = is_script(piece) && i > 0 && is_script(pieces[i - 1]);
        if (first && is_short(piece) && is_short(pieces[i + 1])) written += writer.above;
        written += writer.open[kind];
        if (second) written += writer.second;
        written += inside;
        written += writer.close[kind];
    }
    return written;
}

/// Each character that `replacements` names, replaced.
std::string replaced(std::string_view text, const std::map<char, std::string_view>& replacements) {
    std::string result;
    for (const char c : text)
        if (const auto found = replacements.find(c); found != replacements.end())
            result += found->second;
        else
            result += c;
    return result;
}

std::string escape_enhanced(std::string_view text) {
    return replaced(text, {{'\\', "\\\\"},
                           {'{', "\\{"},
                           {'}', "\\}"},
                           {'_', "\\_"},
                           {'^', "\\^"},
                           {'@', "\\@"},
                           {'&', "\\&"},
                           {'~', "\\~"}});
}

std::string escape_html(std::string_view text) {
    return replaced(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
}

std::string escape_latex(std::string_view text) {
    return replaced(text, {{'\\', "\\textbackslash{}"},
                           {'{', "\\{"},
                           {'}', "\\}"},
                           {'_', "\\_"},
                           {'^', "\\textasciicircum{}"},
                           {'~', "\\textasciitilde{}"},
                           {'&', "\\&"},
                           {'%', "\\%"},
                           {'#', "\\#"},
                           {'$', "\\$"},
                           {'<', "$<$"},
                           {'>', "$>$"},
                           {'|', "$|$"}});
}

std::string as_it_is(std::string_view text) {
    return std::string{text};
}

}  // namespace

std::string tex_to_enhanced(std::string_view tex) {
    // the latter of two scripts is a little smaller, or gnuplot's SVG forgets that it is a script and writes it large
    return write(read(tex), {escape_enhanced,
                             {"", "{/serif:Italic ", "{/serif:Bold ", "_{", "^{"},
                             {"", "}", "}", "}", "}"},
                             "@",
                             "/*0.99 "});
}

std::string tex_to_latex(std::string_view tex) {
    (void)read(tex);  // what the other pictures could not show is an error in this one too
    std::string latex;
    for (const Stretch& stretch : stretches(tex)) {
        if (stretch.formula) {
            latex += "$" + stretch.text + "$";
            continue;
        }
        // A quote before a word opens it, any other closes it, by name since gnuplot can't read two apostrophes.
        for (const char c : escape_latex(stretch.text)) {
            const bool opens = latex.empty() || latex.ends_with(' ') || latex.ends_with('(');
            if (c != '"')
                latex += c;
            else
                latex += opens ? "``" : "{\\textquotedblright}";
        }
    }
    return latex;
}

std::string tex_to_html(std::string_view tex) {
    return write(
        read(tex),
        {escape_html, {"", "<i>", "<b>", "<sub>", "<sup>"}, {"", "</i>", "</b>", "</sub>", "</sup>"}});
}

std::string tex_to_plain(std::string_view tex) {
    return write(read(tex), {as_it_is, {}, {}});
}

}  // namespace sr::course
