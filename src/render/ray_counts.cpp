#include "render/ray_counts.h"

#include <algorithm>

#include <fmt/format.h>

namespace isomotion::render {

void add(const RayCounts& from, RayCounts& to) {
    for (std::size_t k = 0; k < to.size(); ++k) {
        to[k].evaluations += from[k].evaluations;
        to[k].most = std::max(to[k].most, from[k].most);
        if (to[k].undecided == 0) {
            to[k].column = from[k].column;
            to[k].row = from[k].row;
        }
        to[k].undecided += from[k].undecided;
    }
}

std::int64_t evaluations(const RayCounts& of) {
    std::int64_t sum = 0;
    for (const RayCount& count : of) sum += count.evaluations;
    return sum;
}

std::array<std::int64_t, ray_kind_names.size()> each(const RayCounts& of,
                                                     std::int64_t RayCount::*count) {
    std::array<std::int64_t, ray_kind_names.size()> numbers{};
    std::ranges::transform(of, numbers.begin(), count);
    return numbers;
}

std::string words(const RayCounts& counts, std::int64_t pixels) {
    std::string text;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const RayCount& of = counts[k];
        if (of.evaluations == 0) continue;
        text += fmt::format("{}{} {:.2f}{}, at most {}", text.empty() ? "" : "; ",
                            ray_kind_names[k], double(of.evaluations) / double(pixels),
                            text.empty() ? " a pixel" : "", of.most);
        if (of.undecided > 0)
            text += fmt::format(", {} ray{} undecided", of.undecided, of.undecided == 1 ? "" : "s");
    }
    return text;
}

} // namespace isomotion::render
