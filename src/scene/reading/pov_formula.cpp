#include "scene/reading/pov_formula.h"

#include <utility>

#include <fmt/format.h>

namespace isomotion::scene {
namespace {

using SolidKind = PovSolid::Kind;

constexpr std::size_t most_pieces = 20'000, most_moved = 200'000;
constexpr std::size_t longest_moved = 160; // bytes of a formula whose x, y and z are replaced

std::string list(std::string_view function, const std::vector<std::string>& texts) {
    return texts.size() == 1 ? texts[0] : fmt::format("{}({})", function, fmt::join(texts, ", "));
}

std::string negative(const std::string& text) { return fmt::format("-({})", text); }

// Where the first is below 0; a jump is no part of the surface.
std::string cut_open(const std::string& within, const std::string& text) {
    return fmt::format("if({} < 0, {}, 1)", within, text);
}

} // namespace

std::optional<std::string> PovFormula::of(const PovSolid& solid) {
    named_.clear();
    definitions_.clear();
    const Piece whole = piece(solid, PovPlace(), false);
    if (whole.is_clear) return std::nullopt;
    return definitions_ + whole.text;
}

PovFormula::Piece PovFormula::piece(const PovSolid& solid, const PovPlace& around, bool is_clear) {
    if (++pieces_ > most_pieces)
        at_->fail_in(solid.line, solid.word, fmt::format("more than {} objects", most_pieces));
    if ((moves_ += solid.moves.size()) > most_moved)
        at_->fail_in(solid.line, solid.word, fmt::format("more than {} motions", most_moved));
    const PovPlace place = around.before(solid.moves);
    if (place.is_long()) at_->fail_in(solid.line, solid.word, "is too long a formula");
    if (solid.look.color) is_clear = solid.look.is_clear;
    Piece whole{"", is_clear};
    bool is_inverse = solid.is_inverse;
    if (solid.kind == SolidKind::formula) {
        whole.text = moved(solid, solid.formula, place);
    } else {
        std::vector<Piece> pieces;
        std::vector<std::string> texts;
        for (const auto& part : solid.parts) {
            pieces.push_back(piece(*part, place, is_clear));
            texts.push_back(pieces.back().text);
        }
        if (solid.kind == SolidKind::meet) {
            whole = met(pieces);
        } else if (solid.kind == SolidKind::clip) {
            // What is clipped away is outside of an inverse, too.
            const std::string inner =
                std::exchange(is_inverse, false) ? negative(texts[0]) : texts[0];
            texts.erase(texts.begin());
            whole = {cut_open(list("max", texts), inner), pieces[0].is_clear};
        } else if (solid.kind == SolidKind::surfaces) {
            // 0 where one of them is. Within 1 the product is no larger than floats.
            whole.text = fmt::format("clamp({}, -1, 1)", fmt::join(texts, ", -1, 1)*clamp("));
        } else {
            whole = united(solid, pieces);
        }
    }
    const bool is_cut = solid.bounds && !solid.bounds->is_hint;
    if (is_inverse && !(is_cut && solid.bounds->is_capped)) whole.text = negative(whole.text);
    if (is_cut) {
        const std::string within = moved(solid, solid.bounds->formula, place);
        whole.text = solid.bounds->is_capped ? list("max", {whole.text, within})
                                             : cut_open(within, whole.text);
        if (is_inverse && solid.bounds->is_capped) whole.text = negative(whole.text);
    }
    return whole;
}

PovFormula::Piece PovFormula::united(const PovSolid& solid,
                                     const std::vector<Piece>& pieces) const {
    std::vector<std::string> texts;
    for (const Piece& piece : pieces) {
        if (piece.is_clear != pieces[0].is_clear) {
            at_->fail_in(solid.line, solid.word,
                         "has clear parts beside others, which is read only of a union that "
                         "stands alone: leave the clear parts out");
        }
        texts.push_back(piece.text);
    }
    return {list("min", texts), pieces[0].is_clear};
}

PovFormula::Piece PovFormula::met(const std::vector<Piece>& pieces) {
    std::vector<std::string> seen, clear;
    for (const Piece& piece : pieces) (piece.is_clear ? clear : seen).push_back(piece.text);
    if (seen.empty()) return {list("max", clear), true};
    if (clear.empty()) return {list("max", seen), false};
    return {cut_open(list("max", clear), list("max", seen)), false};
}

std::string PovFormula::moved(const PovSolid& solid, const std::string& formula,
                              const PovPlace& place) {
    std::string text;
    if (place.is_still() || formula.size() <= longest_moved) {
        text = at_pov_place(formula, place);
    } else {
        std::string& name = named_[formula];
        for (std::size_t k = named_.size(); name.empty(); ++k) {
            const std::string next = fmt::format("part{}", k);
            if (is_name_(next)) continue;
            name = next;
            definitions_ += fmt::format("{} = {}; ", name, formula);
            bytes_ += formula.size();
        }
        const auto point = place.texts(); // POV-Ray's y is our z
        text = fmt::format("{}({}, {}, {})", name, point[0], point[2], point[1]);
    }
    bytes_ += text.size();
    if (bytes_ > longest_pov_text) at_->fail_in(solid.line, solid.word, "is too long a formula");
    return text;
}

} // namespace isomotion::scene
