// What rows of keys say of values at a time.
#pragma once

#include <glm/glm.hpp>

#include "scene/key.h"
#include "scene/scene_at.h"

namespace isomotion::scene::keys {

// Reads the value of each key that is set by read(row, track), which checks it, and puts it into
// the member of `to` that the row names.
template<class Table, class Of, class At, class Read>
void put_values(const Table& table, const Of& of, At& to, const Read& read) {
    for_each_row(table, [&]<class Row>(const Row& row) {
        if constexpr (is_animated<Row>) {
            const auto* track = set_track(row, of);
            if (!track) return;
            const auto value = read(row, *track);
            if constexpr (requires { to.*row.value = value; }) to.*row.value = value;
        }
    });
}

// From world to the formula coordinates of a surface at `place`.
template<class Value>
Value in_formula_coordinates(Value value, Unit unit, const PlacementAt& place) {
    switch (unit) {
    case Unit::none:
    case Unit::color:
        return value;
    case Unit::length:
        return value / place.scale;
    case Unit::per_length:
        return value * place.scale;
    case Unit::position:
        if constexpr (std::is_same_v<Value, glm::dvec3>) return place.to_local(value);
        break;
    case Unit::direction:
        if constexpr (std::is_same_v<Value, glm::dvec3>)
            return glm::transpose(place.rotate) * value;
        break;
    }
    return value;
}

template<class Table, class At>
void move_values(const Table& table, At& now, const PlacementAt& place) {
    for_each_row(table, [&]<class Row>(const Row& row) {
        if constexpr (requires { now.*row.value = now.*row.value; })
            now.*row.value = in_formula_coordinates(now.*row.value, row.kind.unit, place);
    });
}

} // namespace isomotion::scene::keys
