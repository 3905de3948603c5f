#include "topology/search/sphere.h"

#include <algorithm>

namespace isomotion::topology {
namespace {

using formula::Interval;

void divide(const Box& box, const Box& domain, std::vector<Box>& halves) {
    std::size_t side = 0;
    double widest = 0;
    for (std::size_t k = 0; k < most_variables; ++k) {
        const double whole = domain[k].hi - domain[k].lo;
        const double width = whole > 0 ? (box[k].hi - box[k].lo) / whole : 0;
        if (!(width > widest)) continue;
        widest = width;
        side = k;
    }
    Box low = box, high = box;
    low[side].hi = high[side].lo = mid(box[side]);
    halves.push_back(low);
    halves.push_back(high);
}

} // namespace

std::vector<Box> on_the_sphere(const MovingField& inside, std::size_t most,
                               const std::function<bool()>& stopped) {
    constexpr std::size_t together = 64;
    Enclosures enclosures(inside);
    std::vector<Box> boxes{inside.domain()};
    std::vector<Interval> values;
    // Sides shrink to a thousandth: a gap below that is not told from none.
    for (int level = 0; level < 40 && boxes.size() <= most; ++level) {
        std::vector<Box> kept;
        for (std::size_t first = 0; first < boxes.size(); first += together) {
            if (stopped && stopped()) return boxes;
            std::vector<Box> halves;
            for (std::size_t k = first; k < std::min(first + together, boxes.size()); ++k)
                divide(boxes[k], inside.domain(), halves);
            std::erase_if(halves,
                          [&](const Box& box) { return !contains(enclosures.reach(box), 0.0); });
            enclosures.values(enclosures.all(), halves, values);
            for (std::size_t k = 0; k < halves.size(); ++k) {
                if (contains(values[k], 0.0)) kept.push_back(halves[k]);
            }
        }
        boxes = std::move(kept);
    }
    return boxes;
}

} // namespace isomotion::topology
