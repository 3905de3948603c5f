#include "scene/particles/attribute_names.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

namespace isomotion::scene {
namespace {

struct Usual {
    std::string_view name; // in lower case
    std::array<std::string_view, 4> components;
    std::size_t fewest, most;
};

constexpr Usual usual[] = {
    {"position", {"x", "y", "z", "w"}, 3, 4},
    {"positions", {"x", "y", "z", "w"}, 3, 4},
    {"pos", {"x", "y", "z", "w"}, 3, 4},
    {"p", {"x", "y", "z", "w"}, 3, 4},
    {"points", {"x", "y", "z"}, 3, 3},
    {"velocity", {"vx", "vy", "vz"}, 3, 3},
    {"velocities", {"vx", "vy", "vz"}, 3, 3},
    {"vel", {"vx", "vy", "vz"}, 3, 3},
    {"v", {"vx", "vy", "vz"}, 3, 3},
    {"color", {"r", "g", "b", "a"}, 3, 4},
    {"colors", {"r", "g", "b", "a"}, 3, 4},
    {"colour", {"r", "g", "b", "a"}, 3, 4},
    {"rgb", {"r", "g", "b", "a"}, 3, 4},
    {"rgba", {"r", "g", "b", "a"}, 3, 4},
    {"cd", {"r", "g", "b", "a"}, 3, 4},
    {"normal", {"nx", "ny", "nz"}, 3, 3},
    {"normals", {"nx", "ny", "nz"}, 3, 3},
    {"n", {"nx", "ny", "nz"}, 3, 3},
    {"id", {"id"}, 1, 1},
    {"ids", {"id"}, 1, 1},
    {"particleid", {"id"}, 1, 1},
    {"particle_id", {"id"}, 1, 1},
    {"red", {"r"}, 1, 1},
    {"green", {"g"}, 1, 1},
    {"blue", {"b"}, 1, 1},
    {"alpha", {"a"}, 1, 1},
};

const Usual* find_usual(std::string_view attribute, std::size_t components) {
    std::string lower(attribute);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) {
        return 'A' <= c && c <= 'Z' ? char(c - 'A' + 'a') : char(c);
    });
    for (const Usual& one : usual) {
        if (one.name == lower && one.fewest <= components && components <= one.most) return &one;
    }
    return nullptr;
}

} // namespace

void add_names(std::vector<std::string>& names, std::string_view attribute,
               std::size_t components) {
    if (const Usual* known = find_usual(attribute, components)) {
        const auto begin = known->components.begin(), end = begin + std::ptrdiff_t(components);
        if (std::none_of(begin, end, [&](std::string_view name) {
                return std::ranges::find(names, name) != names.end();
            })) {
            names.insert(names.end(), begin, end);
            return;
        }
    }
    if (components == 1) {
        names.emplace_back(attribute);
        return;
    }
    for (std::size_t k = 0; k < components; ++k)
        names.push_back(fmt::format("{}_{}", attribute, k));
}

std::vector<std::string> names_without_names(std::size_t columns) {
    constexpr const char* known[] = {"x", "y", "z", "vx", "vy", "vz"};
    std::vector<std::string> names;
    for (std::size_t k = 0; k < columns; ++k) {
        const bool has_name = k < 3 || (k < 6 && columns >= 6);
        names.push_back(has_name ? known[k] : fmt::format("c{}", k));
    }
    return names;
}

} // namespace isomotion::scene
