#include "formula/glsl/array_texels.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

namespace isomotion::formula {
namespace {

int slot_of(int array, int field, const ArrayPacking& packing) {
    const auto& fields = packing.at(std::size_t(array));
    const auto it = std::find(fields.begin(), fields.end(), field);
    assert(it != fields.end());
    return int(it - fields.begin());
}

} // namespace

std::string element_text(int array, int field, const ArrayPacking& packing) {
    const int slot = slot_of(array, field, packing);
    return fmt::format("a{}_{}.{}", array, slot / 4, "xyzw"[slot % 4]);
}

std::set<int> texels_read(const Program& program, std::size_t begin, const ArrayPacking& packing) {
    const int array = program.instructions[begin].index;
    std::set<int> texels;
    int depth = 0;
    for (std::size_t at = begin; at < program.instructions.size(); ++at) {
        const Instruction& now = program.instructions[at];
        if (now.kind == Instruction::Kind::loop_begin) ++depth;
        if (now.kind == Instruction::Kind::loop_end && --depth == 0) break;
        if (now.kind == Instruction::Kind::operation && now.op == Op::element &&
            now.index == array) {
            texels.insert(slot_of(array, now.second, packing) / 4);
        }
    }
    return texels;
}

} // namespace isomotion::formula
