#include "scene/key_sections.h"

#include <cmath>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "scene/data_folder.h"
#include "scene/key_tables.h"
#include "scene/surfaces.h"

namespace isomotion::scene {
namespace {

std::string number_text(double number) {
    return number >= 1e6 ? fmt::format("10^{:g}", std::log10(number)) : fmt::format("{}", number);
}

std::string range_text(const keys::Allowed& allowed) {
    const bool has_ends = allowed.least > -keys::unbounded && allowed.most < keys::unbounded &&
                          !allowed.without_least && !allowed.without_most;
    if (!has_ends) return allowed.words();
    return fmt::format("{} to {}", number_text(allowed.least), number_text(allowed.most));
}

std::string default_text(const keys::Kind& kind, bool is_vector) {
    if (!kind.standard) return "";
    const auto& [x, y, z] = *kind.standard;
    return is_vector ? fmt::format("[{}, {}, {}]", x, y, z) : fmt::format("{}", x);
}

template<class Of, class Track, class At, class Value>
KeyDescription described(const keys::Animated<Of, Track, At, Value>& row) {
    const keys::Kind& kind = row.kind;
    KeyDescription key{row.name};
    key.type = !row.is_vector                   ? KeyType::animated
               : kind.unit == keys::Unit::color ? KeyType::color
                                                : KeyType::animated_vector;
    key.is_needed = kind.needed != nullptr;
    const std::string range = range_text(kind.allowed);
    key.what = fmt::format("{}{}{}; animated", row.what, range.empty() ? "" : "; ", range);
    key.otherwise = *row.otherwise ? row.otherwise : default_text(kind, row.is_vector);
    return key;
}

template<class Of, class Value> KeyDescription described(const keys::Still<Of, Value>& row) {
    KeyDescription key{row.name};
    key.what = row.what;
    key.otherwise = row.otherwise;
    if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, double>) {
        key.type = std::is_same_v<Value, int> ? KeyType::integer : KeyType::number;
        key.least = row.allowed.least;
        key.most = row.allowed.most;
        key.what += "; " + range_text(row.allowed);
    } else {
        key.type = KeyType::truth;
    }
    if constexpr (std::is_arithmetic_v<Value>) {
        if (key.otherwise.empty()) key.otherwise = fmt::format("{}", Of{}.*row.member);
    }
    return key;
}

template<class Of, class E> KeyDescription described(const keys::Choice<Of, E>& row) {
    KeyDescription key{row.name};
    key.type = KeyType::word;
    std::vector<std::string> quoted;
    for (const auto& word : row.words) {
        key.words.emplace_back(word.name);
        quoted.push_back(fmt::format("`{}`", word.name));
    }
    key.what = fmt::format("{}{}{}", fmt::join(quoted, ", "), *row.what ? ": " : "", row.what);
    key.otherwise = row.otherwise;
    return key;
}

KeyDescription described(const keys::ReadByHand& row) {
    KeyDescription key{row.name};
    key.schema = row.schema;
    key.what = row.what;
    key.otherwise = row.otherwise;
    return key;
}

// The section with the keys of these tables.
template<class... Tables>
SectionDescription with_keys(SectionDescription section, const Tables&... tables) {
    [[maybe_unused]] const auto add = [&](const auto& row) {
        section.keys.push_back(described(row));
    };
    (keys::for_each_row(tables, add), ...);
    return section;
}

KeyDescription look_key() {
    KeyDescription key{"look", KeyType::word};
    key.words = look_names();
    key.words.emplace_back("none");
    key.what = "light, shading and background together, where the scene says nothing itself: "
               "[looks](#looks)";
    key.otherwise = "`none`";
    return key;
}

} // namespace

std::vector<SectionDescription> key_sections() {
    using namespace keys;
    std::vector<SectionDescription> all;
    const auto add = [&](SectionDescription section, const auto&... tables) {
        all.push_back(with_keys(std::move(section), tables...));
    };
    add({""}, title_keys);
    all.back().keys.push_back(look_key());
    add({"time", 0, "", "one frame"}, time_keys);
    add({"surface", 0, "one of `formula` and `use`"}, surface_keys);
    add({"surface.bounds", 0, "what lies beyond is not drawn: a ball or a box",
         "the catalogue's; of a formula a ball about the surface, found by intervals, or of radius "
         "3 where it goes on for ever"},
        ball_keys, box_keys);
    add({"surface.transform", 0, "from formula to world coordinates", "none"}, transform_keys);
    add({"surfaces", most_surfaces,
         "in place of `[surface]`: has its keys, and `parameters`, `arrays`, `material` and "
         "`isolation` of its own, which go before those that all share, [see "
         "below](#several-surfaces)"},
        listed_surface_keys);
    add({"parameters", 0, "`name = ` animated value", "the catalogue's"});
    add({"arrays.NAME", 0,
         "for `sum(NAME, ...)`. Any other key is a field: a number, an expression "
         "in `t`, `i` (0 to n-1), `n`, parameters and other fields, or a list"},
        array_keys);
    add({"isolation", 0, "how roots are found"}, isolation_keys);
    add({"camera", 0, "stands at a position, or on an orbit", "looks at the bounds"}, camera_keys);
    add({"lights", limits::lights, "", "one over the viewer's shoulder"}, light_place_keys,
        light_keys);
    add({"sections", limits::sections,
         "what is cut off the solid F < 0, [see below](#sections): a half-space or a ball", "none"},
        plane_keys, cut_ball_keys);
    add({"material"}, color_keys, cap_keys, material_keys, blinn_phong_keys, ggx_keys, glass_keys);
    add({"material.colormap", 0,
         "colours the surface by a number, [see below](#colour-by-a-number)"},
        colormap_keys);
    add({"material.contours", 0,
         "lines where a number of the place is a multiple of `every`, [see below](#contours)",
         "none"},
        contour_value_keys, contour_keys);
    add({"ground", 0, "a plane without end; no part of the surface and of no channel", "none"},
        ground_keys);
    add({"fog", 0, "fades by exp(-density (way - start)) with the way from the eye", "none"},
        fog_keys);
    add({"ambient", 0, "light from everywhere", "a little white, 0.12"}, ambient_keys);
    add({"occlusion", 0,
         "less of the light from everywhere where something is near along the normal", "none"},
        occlusion_keys);
    add({"environment", 0, "light from far away", "none"}, environment_keys);
    add({"output"}, output_keys);
    return all;
}

} // namespace isomotion::scene
