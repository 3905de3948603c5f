#include "shader/feature.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "base/nearest_name.h"

namespace isomotion::shader {
namespace {

constexpr std::array feature_table{
    FeatureTraits{Feature::compute, "COMPUTE", FeatureKind::flag},
    FeatureTraits{Feature::rectangles, "RECTANGLES", FeatureKind::flag},
    FeatureTraits{Feature::squares, "SQUARES", FeatureKind::flag},
    FeatureTraits{Feature::flat_shading, "FLAT_SHADING", FeatureKind::flag},
    FeatureTraits{Feature::workgroup_side, "WORKGROUP_SIDE"},
    FeatureTraits{Feature::eye_rays, "EYE_RAYS", FeatureKind::flag},
    FeatureTraits{Feature::mirrored_rays, "MIRRORED_RAYS", FeatureKind::flag},
    FeatureTraits{Feature::path_rays, "PATH_RAYS", FeatureKind::flag},
    FeatureTraits{Feature::ended_rays, "ENDED_RAYS", FeatureKind::flag},
    FeatureTraits{Feature::draws_at_once, "DRAWS_AT_ONCE", FeatureKind::flag},
    FeatureTraits{Feature::settled_rays, "SETTLED_RAYS", FeatureKind::flag},
    FeatureTraits{Feature::march_takes_gradient, "MARCH_TAKES_GRADIENT", FeatureKind::flag},
    FeatureTraits{Feature::caps_by_samples, "CAPS_BY_SAMPLES", FeatureKind::flag},
    FeatureTraits{Feature::bounds_pieces, "BOUNDS_PIECES", FeatureKind::flag},
    FeatureTraits{Feature::counts_rays, "COUNTS_RAYS", FeatureKind::flag},
    FeatureTraits{Feature::masks_blocks, "MASKS_BLOCKS", FeatureKind::flag},
    FeatureTraits{Feature::three_samples, "THREE_SAMPLES", FeatureKind::flag},
    FeatureTraits{Feature::beams, "BEAMS", FeatureKind::flag},
    FeatureTraits{Feature::lists, "LISTS", FeatureKind::flag},
    FeatureTraits{Feature::grid, "GRID", FeatureKind::flag},
    FeatureTraits{Feature::copies, "COPIES", FeatureKind::flag},
    FeatureTraits{Feature::branches, "BRANCHES", FeatureKind::flag},
    FeatureTraits{Feature::scene_steps, "SCENE_STEPS", FeatureKind::flag},
    FeatureTraits{Feature::adaptive_steps, "ADAPTIVE_STEPS", FeatureKind::flag},
    FeatureTraits{Feature::taylor_test, "TAYLOR_TEST", FeatureKind::flag},
    FeatureTraits{Feature::samples_slope, "SAMPLES_SLOPE", FeatureKind::flag},
    FeatureTraits{Feature::breaks, "BREAKS", FeatureKind::flag},
    FeatureTraits{Feature::rough, "ROUGH", FeatureKind::flag},
    FeatureTraits{Feature::walls, "WALLS", FeatureKind::flag},
    FeatureTraits{Feature::bounded_touches, "BOUNDED_TOUCHES", FeatureKind::flag},
    FeatureTraits{Feature::most_tries, "MOST_TRIES"},
    FeatureTraits{Feature::solves, "SOLVES", FeatureKind::flag},
    FeatureTraits{Feature::settles, "SETTLES", FeatureKind::flag},
    FeatureTraits{Feature::passes_free, "PASSES_FREE", FeatureKind::flag},
    FeatureTraits{Feature::signs_in_free_cells, "SIGNS_IN_FREE_CELLS", FeatureKind::flag},
    FeatureTraits{Feature::footprint, "FOOTPRINT", FeatureKind::flag},
    FeatureTraits{Feature::box, "BOX", FeatureKind::flag},
    FeatureTraits{Feature::hits, "HITS", FeatureKind::flag},
    FeatureTraits{Feature::meets_ground, "MEETS_GROUND", FeatureKind::flag},
    FeatureTraits{Feature::mirrored_shadows, "MIRRORED_SHADOWS", FeatureKind::flag},
    FeatureTraits{Feature::glass_shadows, "GLASS_SHADOWS", FeatureKind::flag},
    FeatureTraits{Feature::environment, "ENVIRONMENT", FeatureKind::flag},
    FeatureTraits{Feature::sky_environment, "SKY_ENVIRONMENT", FeatureKind::flag},
    FeatureTraits{Feature::sky_gradient, "SKY_GRADIENT", FeatureKind::flag},
    FeatureTraits{Feature::ambient, "AMBIENT", FeatureKind::flag},
    FeatureTraits{Feature::fog, "FOG", FeatureKind::flag},
    FeatureTraits{Feature::transparent, "TRANSPARENT", FeatureKind::flag},
    FeatureTraits{Feature::ggx, "GGX", FeatureKind::flag},
    FeatureTraits{Feature::blinn_phong, "BLINN_PHONG", FeatureKind::flag},
    FeatureTraits{Feature::lights, "LIGHTS"},
    FeatureTraits{Feature::near_lights, "NEAR_LIGHTS", FeatureKind::flag},
    FeatureTraits{Feature::shadows, "SHADOWS"},
    FeatureTraits{Feature::light_beams, "LIGHT_BEAMS"},
    FeatureTraits{Feature::sections, "SECTIONS"},
    FeatureTraits{Feature::section_balls, "SECTION_BALLS"},
    FeatureTraits{Feature::parts, "PARTS"},
    FeatureTraits{Feature::surfaces, "SURFACES"},
    FeatureTraits{Feature::surface, "SURFACE"},
    FeatureTraits{Feature::ends_before, "ENDS_BEFORE", FeatureKind::flag},
    FeatureTraits{Feature::moved_ends, "MOVED_ENDS", FeatureKind::flag},
    FeatureTraits{Feature::mirrors, "MIRRORS"},
    FeatureTraits{Feature::follows_paths, "FOLLOWS_PATHS", FeatureKind::flag},
    FeatureTraits{Feature::two_sides, "TWO_SIDES", FeatureKind::flag},
    FeatureTraits{Feature::paint, "PAINT", FeatureKind::flag},
    FeatureTraits{Feature::color_by_place, "COLOR_BY_PLACE", FeatureKind::flag},
    FeatureTraits{Feature::blue_yellow, "BLUE_YELLOW", FeatureKind::flag},
    FeatureTraits{Feature::curvature, "CURVATURE", FeatureKind::flag},
    FeatureTraits{Feature::contours, "CONTOURS", FeatureKind::flag},
    FeatureTraits{Feature::cap_color, "CAP_COLOR", FeatureKind::flag},
    FeatureTraits{Feature::glass, "GLASS", FeatureKind::flag},
    FeatureTraits{Feature::mirrors_all, "MIRRORS_ALL", FeatureKind::flag},
    FeatureTraits{Feature::ground, "GROUND", FeatureKind::flag},
    FeatureTraits{Feature::stores_paths, "STORES_PATHS", FeatureKind::flag},
    FeatureTraits{Feature::ended_paths, "ENDED_PATHS", FeatureKind::flag},
    FeatureTraits{Feature::begins_paths, "BEGINS_PATHS", FeatureKind::flag},
    FeatureTraits{Feature::ends_at_bounds, "ENDS_AT_BOUNDS", FeatureKind::flag},
    FeatureTraits{Feature::most_crossings, "MOST_CROSSINGS"},
    FeatureTraits{Feature::depth_location, "DEPTH_LOCATION"},
    FeatureTraits{Feature::normal_location, "NORMAL_LOCATION"},
    FeatureTraits{Feature::position_location, "POSITION_LOCATION"},
    FeatureTraits{Feature::cap_location, "CAP_LOCATION"},
    FeatureTraits{Feature::surface_location, "SURFACE_LOCATION"},
    FeatureTraits{Feature::ending_location, "ENDING_LOCATION"},
    FeatureTraits{Feature::way_location, "WAY_LOCATION"},
    FeatureTraits{Feature::beam_boxes, "BEAM_BOXES", FeatureKind::flag},
    FeatureTraits{Feature::block, "BLOCK"},
    FeatureTraits{Feature::square_bits, "SQUARE_BITS"},
    FeatureTraits{Feature::squares_apart, "SQUARES_APART"},
    FeatureTraits{Feature::parent_block, "PARENT_BLOCK"},
    FeatureTraits{Feature::parent_square_bits, "PARENT_SQUARE_BITS"},
    FeatureTraits{Feature::parent_settles, "PARENT_SETTLES", FeatureKind::flag},
    FeatureTraits{Feature::both_ends, "BOTH_ENDS"},
    FeatureTraits{Feature::trimmed, "TRIMMED", FeatureKind::flag},
    FeatureTraits{Feature::list_of_all, "LIST_OF_ALL"},
    FeatureTraits{Feature::lists_of_a_block, "LISTS_OF_A_BLOCK"},
    FeatureTraits{Feature::front, "FRONT"},
    FeatureTraits{Feature::pieces, "PIECES"},
    FeatureTraits{Feature::front_pieces, "FRONT_PIECES"},
    FeatureTraits{Feature::most_terms, "MOST_TERMS"},
    FeatureTraits{Feature::left_out, "LEFT_OUT"},
    FeatureTraits{Feature::texels, "TEXELS"},
    FeatureTraits{Feature::level, "LEVEL"},
    FeatureTraits{Feature::slots, "SLOTS"},
    FeatureTraits{Feature::first_slots, "FIRST_SLOTS"},
    FeatureTraits{Feature::first_block, "FIRST_BLOCK"},
    FeatureTraits{Feature::middle_slots, "MIDDLE_SLOTS"},
    FeatureTraits{Feature::middle_block, "MIDDLE_BLOCK"},
    FeatureTraits{Feature::last_slots, "LAST_SLOTS"},
    FeatureTraits{Feature::last_level, "LAST_LEVEL"},
    FeatureTraits{Feature::larger_block, "LARGER_BLOCK"},
    FeatureTraits{Feature::mask_texels, "MASK_TEXELS"},
    FeatureTraits{Feature::texels_of_none, "TEXELS_OF_NONE"},
    FeatureTraits{Feature::most_cells, "MOST_CELLS"},
    FeatureTraits{Feature::most_elements, "MOST_ELEMENTS"},
    FeatureTraits{Feature::grid_others, "GRID_OTHERS"},
    FeatureTraits{Feature::tape_of_rays, "TAPE_OF_RAYS"},
    FeatureTraits{Feature::tape_inputs, "TAPE_INPUTS"},
    FeatureTraits{Feature::run_tape_of_rays, "RUN_TAPE_OF_RAYS"},
    FeatureTraits{Feature::calls, "CALLS", FeatureKind::flag},
    FeatureTraits{Feature::hessian, "HESSIAN", FeatureKind::flag},
    FeatureTraits{Feature::value_by_model, "VALUE_BY_MODEL", FeatureKind::flag},
    FeatureTraits{Feature::value_by_gradient, "VALUE_BY_GRADIENT", FeatureKind::flag},
    FeatureTraits{Feature::doubles, "DOUBLES", FeatureKind::flag},
    FeatureTraits{Feature::rays, "RAYS"},
    FeatureTraits{Feature::coarse, "COARSE", FeatureKind::flag},
    FeatureTraits{Feature::coarse_block, "COARSE_BLOCK"},
    FeatureTraits{Feature::proved_block, "PROVED_BLOCK"},
    FeatureTraits{Feature::whole_blocks, "WHOLE_BLOCKS", FeatureKind::flag},
    FeatureTraits{Feature::list_across, "LIST_ACROSS"},
    FeatureTraits{Feature::bounds_rounding, "BOUNDS_ROUNDING"},
    FeatureTraits{Feature::literals, "LITERALS"},
    FeatureTraits{Feature::chains, "CHAINS"},
    FeatureTraits{Feature::unrolled, "UNROLLED"},
    FeatureTraits{Feature::fused, "FUSED"},
};

} // namespace

const FeatureTraits& traits(Feature feature) { return feature_table[std::size_t(feature)]; }

std::optional<Feature> feature_of(std::string_view macro) {
    const auto row = std::ranges::find(feature_table, macro, &FeatureTraits::macro);
    if (row == feature_table.end()) return std::nullopt;
    return row->feature;
}

std::string nearest_feature(std::string_view name) {
    std::vector<std::string> macros;
    for (const FeatureTraits& row : feature_table) macros.emplace_back(row.macro);
    return base::nearest_name(name, macros);
}

bool Features::add(Feature feature, std::string value) {
    if (denied_.contains(feature)) {
        throw std::logic_error(
            fmt::format("{} comes after a file that asked for it", traits(feature).macro));
    }
    const auto [known, is_new] = values_.try_emplace(feature, value);
    if (known->second != value) {
        throw std::logic_error(
            fmt::format("{} is {} and {}", traits(feature).macro, known->second, value));
    }
    return is_new;
}

bool Features::has(Feature feature) {
    const bool is_known = values_.contains(feature);
    if (!is_known) denied_.insert(feature);
    return is_known;
}

int Features::value(Feature feature) { return has(feature) ? std::stoi(values_.at(feature)) : 0; }

} // namespace isomotion::shader
