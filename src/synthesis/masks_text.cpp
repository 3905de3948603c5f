#include "synthesis/masks_text.h"

#include <string_view>

#include "synthesis/shader_text.h"

namespace isomotion::synthesis {

void add_masks(ShaderText& text, const FieldStorage& storage) {
    text.define("MASKS", 1);
    text.define("MASK_WORDS", (storage.arrays[0].capacity + 31) / 32);
    text.file("elements/masks.glsl");
}

std::string over_masks(std::string glsl) {
    constexpr std::string_view loop = "for (int e0 = 0; e0 < array0_count; ++e0) {";
    constexpr std::string_view of_bits =
        "for (int word = 0; word < MASK_WORDS; ++word)\n"
        "    for (uint bits = listed_bits(word); bits != 0u; bits &= bits - 1u) {\n"
        "        int e0 = first_listed(word, bits);";
    for (auto at = glsl.find(loop); at != glsl.npos; at = glsl.find(loop, at + of_bits.size()))
        glsl.replace(at, loop.size(), of_bits);
    return glsl;
}

} // namespace isomotion::synthesis
