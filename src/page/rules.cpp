#include "page/rules.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include <nlohmann/json.hpp>

namespace isomotion::page {
namespace {

using Json = nlohmann::ordered_json;
using formula::Instruction, formula::Op, formula::Program;

// The sibling that a parameter of a field's program stands for, if it is none of the tracks.
std::optional<std::size_t> sibling_of(const animation::Animation& animation, int parameter) {
    const int tracks = int(animation.nameable());
    if (parameter < tracks) return std::nullopt;
    return std::size_t(parameter - tracks);
}

// Whether a field is worked out from a track, by whatever way.
bool field_depends(const animation::Animation& animation, std::size_t array, std::size_t field,
                   int on) {
    const int tracks = int(animation.nameable());
    const animation::Array& of = animation.arrays()[array];
    std::vector<int> open{tracks + int(field)}; // tracks, and fields behind them
    std::set<int> seen;
    while (!open.empty()) {
        const int now = open.back();
        open.pop_back();
        const auto sibling = sibling_of(animation, now);
        // A field with one value is a track, too, behind those that can be named.
        const bool is_it = sibling ? animation.tracks()[std::size_t(on)].name ==
                                         of.name + "." + of.fields[*sibling].name
                                   : now == on;
        if (is_it) return true;
        if (!seen.insert(now).second) continue;
        const Program* program =
            sibling ? animation.program(array, *sibling) : animation.program(now);
        if (!program) continue;
        for (const int other : named_by(*program)) open.push_back(other);
    }
    return false;
}

// Fields in an order in which each comes after its siblings that it is made of.
void add_in_order(const animation::Animation& animation, std::size_t array, std::size_t field,
                  std::vector<std::size_t>& order) {
    if (std::ranges::find(order, field) != order.end()) return;
    if (const Program* program = animation.program(array, field)) {
        for (const int other : named_by(*program)) {
            if (const auto sibling = sibling_of(animation, other))
                add_in_order(animation, array, *sibling, order);
        }
    }
    order.push_back(field);
}

bool is_column(const animation::Animation& animation, std::size_t array, std::size_t field) {
    const auto& source = animation.arrays()[array].fields[field].source;
    return std::holds_alternative<animation::Column>(source);
}

void add_track_in_order(const animation::Animation& animation, int track, std::vector<int>& order) {
    if (std::ranges::find(order, track) != order.end()) return;
    if (const Program* program = animation.program(track)) {
        for (const int other : named_by(*program)) add_track_in_order(animation, other, order);
        order.push_back(track);
    }
}

Json json_of(const Program& program, int tracks, const std::vector<std::size_t>& siblings) {
    Json code = Json::array(), named = Json::array();
    for (const Instruction& now : program.instructions) {
        Json line{now.result, formula::name(now.op)};
        switch (now.op) {
        case Op::constant:
            line.push_back(now.value);
            break;
        case Op::input:
            line.push_back(now.index);
            break;
        case Op::parameter:
            if (now.index < tracks) {
                line.push_back(now.index);
                named.push_back(now.index);
            } else {
                line[1] = "sibling";
                const auto at = std::ranges::find(siblings, std::size_t(now.index - tracks));
                line.push_back(at - siblings.begin());
            }
            break;
        default:
            for (int k = 0; k < now.arity; ++k) line.push_back(now.operands[std::size_t(k)]);
        }
        code.push_back(std::move(line));
    }
    return {{"code", code}, {"out", program.outputs.front()}, {"tracks", named}};
}

Json fields_of(const scene::Surface& surface, std::size_t array) {
    const animation::Animation& animation = surface.animation;
    const std::vector<std::size_t> order = fields_in_order(surface, array);
    Json all = Json::array();
    for (const std::size_t field : order) {
        Json entry{{"slot", slot_of(surface, array, field)}};
        const auto& source = animation.arrays()[array].fields[field].source;
        if (const Program* program = animation.program(array, field))
            entry["program"] = json_of(*program, int(animation.nameable()), order);
        else if (const auto* number = std::get_if<double>(&source))
            entry["values"] = {*number}; // of all elements
        else if (const auto* list = std::get_if<std::vector<double>>(&source))
            entry["values"] = *list;
        all.push_back(std::move(entry));
    }
    return all;
}

std::vector<int> bounds_tracks(const scene::Bounds& bounds) {
    const auto& [shape, min, max, centre, radius] = bounds;
    if (shape == scene::Bounds::Shape::sphere) return {centre[0], centre[1], centre[2], radius};
    return {min[0], min[1], min[2], max[0], max[1], max[2]};
}

} // namespace

std::set<int> named_by(const Program& program) {
    std::set<int> named;
    for (const Instruction& now : program.instructions) {
        if (now.op == Op::parameter) named.insert(now.index);
    }
    return named;
}

std::vector<std::size_t> fields_in_order(const scene::Surface& surface, std::size_t array) {
    std::vector<std::size_t> order;
    for (const int field : surface.field->packing[array])
        add_in_order(surface.animation, array, std::size_t(field), order);
    return order;
}

int slot_of(const scene::Surface& surface, std::size_t array, std::size_t field) {
    const auto& packing = surface.field->packing[array];
    const auto at = std::ranges::find(packing, int(field));
    return at == packing.end() ? -1 : int(at - packing.begin());
}

Json program_of_track(const animation::Animation& animation, int track) {
    return json_of(*animation.program(track), int(animation.nameable()), {});
}

bool can_be_held(const scene::Surface& surface, int track) {
    const animation::Animation& animation = surface.animation;
    for (std::size_t a = 0; a < animation.arrays().size(); ++a) {
        for (const std::size_t field : fields_in_order(surface, a)) {
            const Program* program = animation.program(a, field);
            if (!program || !field_depends(animation, a, field, track)) continue;
            for (const int other : named_by(*program)) {
                const auto sibling = sibling_of(animation, other);
                if (sibling && is_column(animation, a, *sibling) &&
                    slot_of(surface, a, *sibling) < 0)
                    return false;
            }
        }
    }
    return true;
}

Json rules_of(const scene::Surface& surface) {
    const animation::Animation& animation = surface.animation;
    const auto rule = [&](int key, int track) {
        return Json{key, program_of_track(animation, track)};
    };
    Json rules{{"seed", std::to_string(animation.seed())}};
    std::vector<int> order;
    for (int k = 0; k < surface.parameters; ++k) add_track_in_order(animation, k, order);
    rules["tracks"] = Json::array();
    for (const int track : order) rules["tracks"].push_back(rule(track, track));
    rules["bounds"] = Json::array();
    const std::vector<int> bounds = bounds_tracks(surface.bounds);
    for (std::size_t k = 0; k < bounds.size(); ++k) {
        if (animation.program(bounds[k])) rules["bounds"].push_back(rule(int(k), bounds[k]));
    }
    rules["arrays"] = Json::array();
    for (std::size_t a = 0; a < animation.arrays().size(); ++a)
        rules["arrays"].push_back(fields_of(surface, a));
    return rules;
}

} // namespace isomotion::page
