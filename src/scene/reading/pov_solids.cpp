#include "scene/reading/pov_solids.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "scene/error.h"
#include "scene/reading/pov_known_solids.h"
#include "scene/reading/pov_polynomial.h"
#include "scene/reading/pov_shapes.h"

namespace isomotion::scene {
namespace {

using SolidKind = PovSolid::Kind;

constexpr int deepest_solid = 60;    // parts of parts
constexpr int most_solids = 100'000; // that a file writes out
constexpr std::string_view solid_words[] = {
    "sphere",         "box",     "cylinder", "cone",         "torus",      "plane",
    "superellipsoid", "quadric", "cubic",    "quartic",      "poly",       "blob",
    "isosurface",     "union",   "merge",    "intersection", "difference", "object"};

bool is_group(const std::string& word) {
    return word == "union" || word == "merge" || word == "intersection" || word == "difference";
}

// Of an isosurface without contained_by.
PovBounds unit_box(std::size_t line) {
    return {line, "{ box = [[-1, -1, -1], [1, 1, 1]] }", "max(abs(x) - 1, abs(y) - 1, abs(z) - 1)",
            false, true};
}

// The ball about a shape as it lay before the object moved; none if that is no ball.
std::optional<PovBounds> moved_back(const PovBounds& shape, const std::vector<PovMove>& moves) {
    double scale = 1;
    for (const PovMove& move : moves) {
        if (move.kind == PovMove::Kind::matrix) return std::nullopt;
        if (move.kind != PovMove::Kind::scale) continue;
        const auto by = still_vector(move.by);
        if (!by || by->x != by->y || by->x != by->z) return std::nullopt;
        scale *= std::abs(by->x);
    }
    const auto centre = shape.ball ? PovPlace().before(moves).at(shape.ball->centre) : std::nullopt;
    if (!centre) return std::nullopt;
    PovBounds bounds = shape;
    bounds.is_hint = true;
    bounds.ball = PovBall{*centre, shape.ball->radius / scale};
    bounds.text = pov_ball_bounds(*bounds.ball);
    return bounds;
}

// The solid without its motions and look stays as the first part; the others come behind it.
void wrap(PovSolid& solid, std::vector<std::shared_ptr<const PovSolid>> others) {
    PovSolid outer;
    outer.kind = SolidKind::clip;
    outer.word = solid.word;
    outer.line = solid.line;
    outer.look = std::exchange(solid.look, PovLook{});
    outer.depth = solid.depth + 1;
    for (const auto& other : others) outer.depth = std::max(outer.depth, other->depth + 1);
    solid.take_looks();
    outer.parts.push_back(std::make_shared<const PovSolid>(std::move(solid)));
    outer.parts.insert(outer.parts.end(), others.begin(), others.end());
    solid = std::move(outer);
}

} // namespace

void PovSolid::take_looks() {
    const std::string own =
        look.color ? look.text() + (look.is_clear ? " clear" : "") : std::string();
    looks.clear();
    is_colored = look.color && !look.is_clear;
    if (parts.empty()) looks.insert(own);
    for (const auto& part : parts) {
        for (const std::string& one : part->looks) {
            if (looks.size() < 2) looks.insert(one.empty() ? own : one);
        }
        is_colored = is_colored || part->is_colored;
    }
}

bool PovSolidReader::is_solid(const PovWord& word) {
    return word.kind == PovWord::Kind::name && std::ranges::count(solid_words, word.text) > 0;
}

std::string PovSolidReader::known_words() {
    std::string all;
    for (const std::string_view word : solid_words)
        all += fmt::format("{}{}", all.empty() ? "" : ", ", word);
    return all;
}

PovSolid PovSolidReader::read(PovCursor& at) {
    PovSolid solid;
    solid.word = at.now().text;
    solid.line = at.now().line;
    if (!is_solid(at.now()))
        at.fail(solid.word,
                fmt::format("is not read; objects that are read are {}", known_words()));
    if (++count_ > most_solids)
        at.fail(solid.word, fmt::format("more than {} objects", most_solids));
    if (++depth_ > deepest_solid)
        at.fail(solid.word, fmt::format("more than {} objects in one another", deepest_solid));
    at.take();
    at.expect("{", solid.word);
    if (solid.word == "object") {
        const std::size_t line = solid.line;
        solid = named(at);
        solid.line = line;
    } else if (is_group(solid.word)) {
        read_parts(at, solid);
    } else {
        read_shape(at, solid);
    }
    read_modifiers(at, solid);
    if (solid.depth > deepest_solid)
        at.fail(solid.word, fmt::format("more than {} objects in one another", deepest_solid));
    --depth_;
    solid.take_looks();
    return solid;
}

void PovSolidReader::declare(const std::string& name, PovCursor& at) {
    const std::size_t begin = at.place();
    const int depth = depth_;
    try {
        declared_[name] = std::make_shared<const PovSolid>(read(at));
        mistakes_.erase(name);
    } catch (const SceneError& mistake) {
        // Whoever uses it is told.
        depth_ = depth;
        declared_.erase(name);
        mistakes_[name] = mistake.what();
        at.go_to(begin);
        at.take();
        if (!at.now().is("{")) throw;
        at.skip_group("#declare " + name);
    }
}

void PovSolidReader::forget(const std::string& name) {
    declared_.erase(name);
    mistakes_.erase(name);
}

PovSolid PovSolidReader::named(PovCursor& at) {
    if (is_solid(at.now())) return read(at);
    const std::string name = at.now().text;
    if (const auto found = mistakes_.find(name); found != mistakes_.end())
        throw SceneError(found->second);
    const auto found = declared_.find(name);
    auto solid = found != declared_.end() ? std::optional(*found->second) : known_pov_solid(name);
    if (!solid) {
        std::vector<std::string> names;
        for (const auto& [known, value] : declared_)
            if (names.size() < most_pov_names) names.push_back(known);
        const std::string near = base::nearest_name(name, names);
        at.fail("object",
                fmt::format("'{}' is not declared before{}", name,
                            near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
    }
    at.take();
    return *solid;
}

void PovSolidReader::read_parts(PovCursor& at, PovSolid& solid) {
    solid.kind = solid.word == "union"   ? SolidKind::unite
                 : solid.word == "merge" ? SolidKind::merge
                                         : SolidKind::meet;
    while (is_solid(at.now())) {
        PovSolid part = read(at);
        if (solid.word == "difference" && !solid.parts.empty()) part.is_inverse ^= true;
        solid.depth = std::max(solid.depth, part.depth + 1);
        solid.parts.push_back(std::make_shared<const PovSolid>(std::move(part)));
    }
    if (solid.parts.empty())
        at.fail(solid.word,
                fmt::format("needs objects before '{}': {}", at.now().text, known_words()));
    const auto is_endless = [](const auto& part) { return part->is_endless; };
    solid.is_endless = solid.word == "difference" ? solid.parts[0]->is_endless
                       : solid.kind == SolidKind::meet
                           ? std::ranges::all_of(solid.parts, is_endless)
                           : std::ranges::any_of(solid.parts, is_endless);
    const auto is_whole = [](const auto& part) { return part->is_closed && !part->is_inverse; };
    solid.is_closed = solid.kind == SolidKind::meet ? std::ranges::any_of(solid.parts, is_whole)
                                                    : std::ranges::all_of(solid.parts, is_whole);
}

void PovSolidReader::read_polynomial(PovCursor& at, PovSolid& solid) {
    if (solid.word == "quadric") {
        solid.formula = pov_quadric(at, *values_);
        return;
    }
    int order = solid.word == "cubic" ? 3 : 4;
    if (solid.word == "poly") {
        const double given = values_->constant(at, "poly");
        if (!(given >= 2 && given <= 35) || given != std::round(given))
            at.fail("poly", "must have an order from 2 to 35");
        order = int(given);
        at.take_if(",");
    }
    solid.formula = pov_polynomial(at, *values_, order, solid.word);
}

void PovSolidReader::read_shape(PovCursor& at, PovSolid& solid) {
    if (read_pov_shape(at, *values_, solid)) return;
    if (solid.word == "isosurface") {
        read_isosurface(at, solid);
    } else if (solid.word == "blob") {
        solid.formula = read_pov_blob(at, *values_, *moves_);
        solid.is_closed = true;
    } else {
        read_polynomial(at, solid);
    }
}

// All of an isosurface, as its own words and those of any object come in any order.
void PovSolidReader::read_isosurface(PovCursor& at, PovSolid& solid) {
    std::optional<PovNumber> function;
    PovNumber threshold = PovNumber::of(0);
    bool is_open = false;
    while (!at.now().is("}")) {
        const PovWord word = at.now();
        if (at.at_end()) at.fail(solid.word, "its braces do not close");
        if (solid.kind != SolidKind::clip && word.is("function")) {
            at.take();
            function = values_->function(at);
        } else if (word.is("threshold")) {
            at.take();
            threshold = values_->number(at, word.text);
        } else if (word.is("open")) {
            at.take();
            is_open = true;
        } else if (word.is("accuracy") || word.is("max_gradient") || word.is("max_trace")) {
            at.take();
            values_->number(at, word.text);
        } else if (word.is("evaluate")) {
            at.take();
            for (int k = 0; k < 3; ++k) {
                if (k > 0) at.take_if(",");
                values_->number(at, "evaluate");
            }
        } else if (word.is("clipped_by") && !function) {
            at.fail(word.text, "is read behind the function");
        } else if (word.is("clipped_by")) {
            if (!solid.bounds || solid.bounds->is_hint) solid.bounds = unit_box(solid.line);
            solid.bounds->is_capped &= !is_open;
            read_bounds(at, solid);
        } else if (!read_modifier(at, solid)) {
            at.fail(solid.word, fmt::format("'{}' is not read here", word.text));
        }
        if (solid.kind == SolidKind::clip) break; // what follows is of the whole
        if (!function) continue;
        solid.formula = threshold.value == 0.0
                            ? function->text
                            : fmt::format("{} - ({})", function->text, threshold.text);
    }
    if (!function) at.fail("isosurface", "needs function { ... }");
    if (solid.kind == SolidKind::clip) return;
    if (!solid.bounds || solid.bounds->is_hint) solid.bounds = unit_box(solid.line);
    solid.bounds->is_capped &= !is_open;
}

void PovSolidReader::read_modifiers(PovCursor& at, PovSolid& solid) {
    while (!at.take_if("}")) {
        if (at.at_end()) at.fail(solid.word, "its braces do not close");
        if (!read_modifier(at, solid))
            at.fail(solid.word, fmt::format("'{}' is not read here", at.now().text));
    }
}

bool PovSolidReader::read_modifier(PovCursor& at, PovSolid& solid) {
    const PovWord word = at.now();
    if (read_pov_move(at, *values_, *moves_, solid.moves) || looks_->read(at, solid.look))
        return true;
    if (word.is("inverse")) {
        at.take();
        solid.is_inverse ^= true;
    } else if (word.is("split_union")) {
        at.take();
        at.take();
    } else if (word.is("contained_by") || word.is("clipped_by") || word.is("bounded_by")) {
        read_bounds(at, solid);
    } else {
        return false;
    }
    return true;
}

// bounded_by only saves time, so that it counts where nothing else bounds the surface.
void PovSolidReader::read_bounds(PovCursor& at, PovSolid& solid) {
    const PovWord word = at.take();
    const bool is_hint = word.is("bounded_by"), is_container = word.is("contained_by");
    at.expect("{", word.text);
    // bounded_by { clipped_by }: the same shape for both.
    if (at.take_if("clipped_by") || at.take_if("bounded_by")) return at.expect("}", word.text);
    std::vector<std::shared_ptr<const PovSolid>> shapes;
    while (!at.take_if("}")) {
        shapes.push_back(std::make_shared<const PovSolid>(read(at)));
        if (shapes.size() > 100) at.fail(word.text, "has more than 100 objects");
    }
    if (shapes.empty()) at.fail(word.text, "needs an object: sphere { <0, 0, 0>, 1 }");
    const PovSolid& first = *shapes[0];
    const bool is_plain = shapes.size() == 1 && first.shape && first.moves.empty() &&
                          !first.is_inverse && first.kind == SolidKind::formula;
    if (is_container && !is_plain) at.fail(word.text, "is read with a sphere or a box");
    const bool is_free = !solid.bounds || solid.bounds->is_hint;
    if (is_hint && (!is_plain || solid.bounds)) return;
    if (is_hint && !solid.moves.empty()) {
        solid.bounds = moved_back(*first.shape, solid.moves);
        return;
    }
    if (is_container && (solid.word != "isosurface" || solid.kind == SolidKind::clip))
        at.fail(word.text, "is read in an isosurface, before clipped_by");
    if (is_container && !is_free) at.fail(word.text, "is the second shape; write one");
    if (is_plain && is_free && (is_container || solid.moves.empty())) {
        solid.bounds = first.shape;
        solid.bounds->line = word.line;
        solid.bounds->is_hint = is_hint;
        solid.bounds->is_capped = is_container;
        return;
    }
    wrap(solid, std::move(shapes));
    if (solid.depth > deepest_solid)
        at.fail(word.text, fmt::format("more than {} objects in one another", deepest_solid));
}

} // namespace isomotion::scene
