#include "scene/found_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "formula/enclosure.h"
#include "formula/interval/interval_operations.h"

namespace isomotion::scene {
namespace {

using formula::Interval;

struct Box {
    glm::dvec3 low, high;
};

Box hull(const Box& a, const Box& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

constexpr Box everywhere{glm::dvec3(-FoundBounds::reach), glm::dvec3(FoundBounds::reach)};

// Operations on intervals, of all regions together; and boxes that are looked at in turn.
constexpr double most_evaluated = 1e8;
constexpr std::size_t most_boxes = 20'000;

// The parts of a box in which F may be 0 at one region's values.
class Cover {
public:
    Cover(const formula::Program& program, const formula::Bindings<Interval>& bindings,
          double operations)
        : evaluator_(program)
        , bindings_(bindings)
        , left_(operations) {
        std::vector<int> counts;
        for (const auto& array : bindings.arrays) counts.push_back(array.count);
        each_ = 1 + formula::cost(program, counts).operations;
    }

    // Halves boxes along all axes as far as `levels` and work allow.
    std::vector<Box> of(const Box& whole, int levels) {
        std::vector<Box> boxes{whole};
        for (int level = 0; level < levels && !boxes.empty(); ++level) {
            const double work = each_ * 8 * double(boxes.size());
            if (work > left_ || 8 * boxes.size() > 4 * most_boxes) break;
            left_ -= work;
            boxes = kept(eighths(boxes));
        }
        return boxes;
    }

private:
    static std::vector<Box> eighths(const std::vector<Box>& boxes) {
        std::vector<Box> parts;
        parts.reserve(8 * boxes.size());
        for (const Box& box : boxes) {
            const glm::dvec3 half = 0.5 * (box.high - box.low);
            for (int k = 0; k < 8; ++k) {
                const glm::dvec3 low = box.low + half * glm::dvec3(k & 1, k >> 1 & 1, k >> 2);
                parts.push_back({low, low + half});
            }
        }
        return parts;
    }

    std::vector<Box> kept(const std::vector<Box>& boxes) {
        std::array<std::vector<Interval>, 3> inputs;
        for (const Box& box : boxes) {
            for (int k = 0; k < 3; ++k)
                inputs[std::size_t(k)].emplace_back(box.low[k], box.high[k]);
        }
        std::vector<Interval> values(boxes.size());
        const std::array<std::span<const Interval>, 3> from{inputs[0], inputs[1], inputs[2]};
        const std::array<std::span<Interval>, 1> to{values};
        evaluator_.points(bindings_, from, to);
        std::vector<Box> found;
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            if (contains(values[k], 0.0)) found.push_back(boxes[k]);
        }
        return found;
    }

    formula::Evaluator<Interval> evaluator_;
    const formula::Bindings<Interval>& bindings_;
    double each_ = 1, left_;
};

bool reaches_out(const Box& box) {
    return glm::any(glm::lessThanEqual(box.low, everywhere.low)) ||
           glm::any(glm::greaterThanEqual(box.high, everywhere.high));
}

// Closer about what is small, a few times.
std::vector<Box> cover(const formula::Program& program, const formula::Region& region,
                       double operations) {
    constexpr int levels = 6, turns = 6;
    Cover covering(program, region.bindings, operations);
    std::vector<Box> boxes = covering.of(everywhere, levels);
    Box whole = everywhere;
    for (int turn = 1; turn < turns && !boxes.empty(); ++turn) {
        Box about = boxes.front();
        for (const Box& box : boxes) about = hull(about, box);
        const glm::dvec3 before = whole.high - whole.low, now = about.high - about.low;
        if (std::max({now.x, now.y, now.z}) > 0.3 * std::max({before.x, before.y, before.z})) break;
        whole = about;
        boxes = covering.of(about, levels);
    }
    return boxes;
}

// Numbers that a person would write, of a ball no smaller.
double rounded_up(double radius) {
    const double unit = std::pow(10.0, std::floor(std::log10(radius)) - 1);
    return std::ceil(radius / unit) * unit;
}

} // namespace

FoundBounds find_bounds(const formula::Field& field, std::span<const formula::Region> regions) {
    const formula::Program program = formula::value_enclosure(field);
    std::vector<Box> all;
    for (const formula::Region& region : regions) {
        const std::vector<Box> boxes =
            cover(program, region, most_evaluated / double(regions.size()));
        for (const Box& box : boxes) {
            if (reaches_out(box)) return {};
        }
        all.insert(all.end(), boxes.begin(), boxes.end());
    }
    if (all.empty()) return {};
    Box about = all.front();
    for (const Box& box : all) about = hull(about, box);
    FoundBounds found;
    found.is_about_surface = true;
    const glm::dvec3 middle = 0.5 * (about.low + about.high);
    const double size = glm::length(about.high - about.low);
    // A surface about the origin has its bounds there.
    for (int k = 0; k < 3; ++k) {
        const double unit = 0.02 * size;
        found.centre[k] = std::round(middle[k] / unit) * unit;
    }
    double farthest = 0;
    for (const Box& box : all) {
        const glm::dvec3 corner =
            glm::max(glm::abs(box.low - found.centre), glm::abs(box.high - found.centre));
        farthest = std::max(farthest, glm::length(corner));
    }
    found.radius = rounded_up(std::max(1.02 * farthest, 1e-6));
    return found;
}

} // namespace isomotion::scene
