#include "shader/beam_copies_text.h"

#include <cassert>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "shader/beam_text.h"

namespace isomotion::shader {
namespace {

constexpr int columns = 16; // of a list

bool is_last(const PassPlan& plan, int level) { return level + 1 == int(plan.beams.size()); }

// Places of a list, the last of which holds how many elements there are. The first level's lists
// may be of all. Fewer matter in smaller beams, and fewest in a last one's front; where there are
// more, rays take what that list was made from. Elements of more texels have fewer places: all
// lists lie in one texture, and WebGL2 promises 2048 rows.
int slots(const PassPlan& plan, int level) {
    const int texels = plan.arrays[0].texels;
    const int of_a_front = std::max(4 / texels, 1) * columns;
    const int of_a_middle = std::max(8 / texels, 1) * columns;
    const int all = (plan.arrays[0].capacity / columns + 1) * columns;
    if (level == 0) return all;
    return std::min(all, is_last(plan, level) ? of_a_front : of_a_middle);
}

int texels_of_a_mask(const FieldStorage& storage) {
    return (storage.arrays[0].capacity + 127) / 128;
}

std::string repeated(std::string_view value, int times) {
    const std::vector<std::string_view> all(std::size_t(times), value);
    return fmt::format("{}", fmt::join(all, ", "));
}

// Adds the places of the lists of larger beams, which this level's beams lie in.
void add_larger(ShaderText& text, const PassPlan& plan, int level) {
    assert(level == 1 || level == 2);
    text.define(Feature::copies);
    text.define(Feature::texels, plan.arrays[0].texels);
    text.define(Feature::first_slots, slots(plan, 0));
    text.define(Feature::larger_block, plan.beams[std::size_t(level - 1)].block);
    if (level == 2) {
        text.define(Feature::first_block, plan.beams[0].block);
        text.define(Feature::middle_block, plan.beams[1].block);
        text.define(Feature::middle_slots, slots(plan, 1));
    }
    text.file("march/copies.glsl");
}

} // namespace

int masks_of_level(const FieldStorage& storage, const BeamLevel& level) {
    return has_copies(storage) ? texels_of_a_mask(storage) * lists_of_a_block(level) : 0;
}

int rows_of_copies(const PassPlan& plan, int level) {
    return slots(plan, level) / columns * plan.arrays[0].texels;
}

bool copies_fit(const PassPlan& plan) {
    int rows = 0;
    for (std::size_t level = 0; level < plan.beams.size(); ++level) {
        const int block = plan.beams[level].block;
        rows += rows_of_copies(plan, int(level)) * ((tile_of_copies + block - 1) / block);
    }
    return rows <= most_rows_of_copies;
}

FieldStorage through_copies(const FieldStorage& storage) {
    FieldStorage reading = storage;
    if (has_copies(storage)) reading.arrays[0].reads_copies = true;
    return reading;
}

FieldStorage storage_at_level(const FieldStorage& storage, int level) {
    return level > 0 ? through_copies(storage) : storage;
}

void add_masks(ShaderText& text, const FieldStorage& storage) {
    const int texels = texels_of_a_mask(storage);
    text.define(Feature::copies);
    text.define(Feature::mask_texels, texels);
    // ES 3.00 has initial values of constants alone.
    text.define(Feature::texels_of_none, repeated("uvec4(0u)", texels));
    text.file("march/write_lists.glsl");
}

void add_copies_of_parent(ShaderText& text, const PassPlan& plan, int level) {
    add_larger(text, plan, level);
}

void add_copies_of_ray(ShaderText& text, const PassPlan& plan) {
    const int last = int(plan.beams.size()) - 1;
    text.define(Feature::last_level, last);
    text.define(Feature::last_slots, slots(plan, last));
    add_larger(text, plan, last);
}

Pass beam_copies_pass(const scene::OneSurface& one, const PassPlan& plan, int level) {
    const BeamLevel& beam = plan.beams[std::size_t(level)];
    ShaderText text;
    text.define(Feature::level, level);
    define_blocks(text, beam);
    text.define(Feature::lists_of_a_block, lists_of_a_block(beam));
    text.define(Feature::slots, slots(plan, level));
    text.define(Feature::mask_texels, texels_of_a_mask(plan));
    add_field(text, *one.surface.field, storage_at_level(plan, level), {});
    if (level > 0)
        add_larger(text, plan, level);
    else
        text.define(Feature::texels, plan.arrays[0].texels);
    text.file("march/copy_lists.frag");
    Pass pass = std::move(text).pass(
        Role::beam_copies, fmt::format("lists of {} pixels", beam.block), When::once_a_tile);
    pass.level = level;
    return pass;
}

} // namespace isomotion::shader
