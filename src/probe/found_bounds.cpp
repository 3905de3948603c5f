#include "probe/found_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "formula/enclosure.h"
#include "formula/interval/interval_operations.h"
#include "scene/error.h"
#include "scene/scene_at.h"

namespace isomotion::probe {
namespace {

using scene::OneSurface, scene::Scene, scene::SceneError, scene::Surface;

using formula::Interval;

struct Box {
    glm::dvec3 low, high;
};

Box hull(const Box& a, const Box& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

// Operations on intervals, of all groups of frames together, that look for a first part of the
// surface, and as many again for what lies beyond it; operations of the frames' values; and boxes
// that are looked at in turn.
constexpr double most_evaluated = 1e8, most_of_frames = 3e7;
constexpr std::size_t most_boxes = 80'000;
constexpr int groups = 16;

using Values = formula::Bindings<Interval>;

bool has_same_counts(const Values& a, const Values& b) {
    return std::ranges::equal(a.arrays, b.arrays, {}, &formula::ArrayColumns<Interval>::count,
                              &formula::ArrayColumns<Interval>::count);
}

void cover(std::vector<Interval>& all, const std::vector<Interval>& more) {
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = formula::hull(all[k], more[k]);
}

void cover(Values& all, const Values& more) {
    cover(all.parameters, more.parameters);
    for (std::size_t a = 0; a < all.arrays.size(); ++a) {
        for (std::size_t f = 0; f < all.arrays[a].fields.size(); ++f)
            cover(all.arrays[a].fields[f], more.arrays[a].fields[f]);
    }
}

// What moves between two frames is looked at there, too.
constexpr int parts_of_frame = 4;

// What names stand for at all frames, neighbours together; none if that takes long.
std::optional<std::vector<Values>> values_of_frames(const OneSurface& one) {
    const animation::Animation& animation = one.surface.animation;
    double each = 100;
    for (std::size_t a = 0; a < animation.arrays().size(); ++a) each += animation.operations(a);
    const int frames = one.scene.timeline.frames;
    if (each * frames > most_of_frames) return std::nullopt;
    const int parts = each * frames * parts_of_frame > most_of_frames ? 1 : parts_of_frame;
    const int moments = (frames - 1) * parts + 1, together = (moments + groups - 1) / groups;
    std::vector<Values> all;
    for (int moment = 0; moment < moments; ++moment) {
        Values now;
        try {
            const double part = double(moment % parts) / parts;
            const double time = one.scene.timeline.time(1 + moment / parts, part);
            now = formula::convert<Interval>(surface_at(one, time).bindings);
        } catch (const SceneError&) { // said where the frame is drawn
            continue;
        }
        const bool is_next = all.empty() || moment % together == 0;
        if (is_next || !has_same_counts(all.back(), now)) {
            all.push_back(std::move(now));
        } else {
            cover(all.back(), now);
        }
    }
    // Neighbouring groups with the same values are searched once.
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

// The parts of a box in which F may be 0 at some values.
class Cover {
public:
    Cover(const formula::Program& program, const Values& values, double operations)
        : evaluator_(program)
        , values_(values)
        , left_(operations) {
        const std::vector<int> counts = values.counts();
        const formula::Cost cost = formula::cost(program, counts);
        // Most boxes meet many cells of noise, which has one bound for them all.
        each_ = 1 + cost.operations - 0.9 * formula::operations_of_noise * cost.noises;
    }

    // Halves boxes along all axes as far as `levels` and work allow. Goes on with those alone that
    // `matters` names.
    template<class Matters>
    std::vector<Box> of(std::vector<Box> boxes, int levels, const Matters& matters) {
        was_cut_short_ = false;
        for (int level = 0; level < levels && !boxes.empty(); ++level) {
            if (8 * boxes.size() > most_boxes) break;
            const double work = each_ * 8 * double(boxes.size());
            if (work > left_) {
                was_cut_short_ = true;
                break;
            }
            left_ -= work;
            boxes = kept(eighths(boxes));
            std::erase_if(boxes, [&](const Box& box) { return !matters(box); });
        }
        return boxes;
    }
    std::vector<Box> of(std::vector<Box> boxes, int levels) {
        return of(std::move(boxes), levels, [](const Box&) { return true; });
    }
    // Whether F has both signs at the corners of these boxes.
    bool changes_sign(const std::vector<Box>& boxes) {
        bool is_below = false, is_above = false;
        for (const Box& box : boxes) {
            std::vector<Box> corners;
            for (int k = 0; k < 8; ++k) {
                const glm::dvec3 part(k & 1, k >> 1 & 1, k >> 2);
                const glm::dvec3 corner = glm::mix(box.low, box.high, part);
                corners.push_back({corner, corner});
            }
            for (const Interval value : values_in(corners)) {
                is_below = is_below || value.hi < 0;
                is_above = is_above || value.lo > 0;
            }
            if (is_below && is_above) return true;
        }
        return false;
    }
    // Whether there was more work than is allowed, the last time.
    bool was_cut_short() const { return was_cut_short_; }

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

    std::vector<Interval> values_in(const std::vector<Box>& boxes) {
        std::array<std::vector<Interval>, 3> inputs;
        for (const Box& box : boxes) {
            for (int k = 0; k < 3; ++k)
                inputs[std::size_t(k)].emplace_back(box.low[k], box.high[k]);
        }
        std::vector<Interval> values(boxes.size());
        const std::array<std::span<const Interval>, 3> from{inputs[0], inputs[1], inputs[2]};
        const std::array<std::span<Interval>, 1> to{values};
        evaluator_.points(values_, from, to);
        return values;
    }

    std::vector<Box> kept(const std::vector<Box>& boxes) {
        const std::vector<Interval> values = values_in(boxes);
        std::vector<Box> found;
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            if (contains(values[k], 0.0)) found.push_back(boxes[k]);
        }
        return found;
    }

    formula::Evaluator<Interval> evaluator_;
    const Values& values_;
    double each_ = 1, left_;
    bool was_cut_short_ = false;
};

bool reaches_out(const Box& box, const Box& of) {
    return glm::any(glm::lessThanEqual(box.low, of.low)) ||
           glm::any(glm::greaterThanEqual(box.high, of.high));
}

Box about_origin(double reach) { return {glm::dvec3(-reach), glm::dvec3(reach)}; }

// The part of a box about the origin that lies beyond a smaller one: a slab at each face.
std::vector<Box> beyond(const Box& held, const Box& whole) {
    std::vector<Box> slabs;
    Box rest = whole;
    for (int axis = 0; axis < 3; ++axis) {
        Box low = rest, high = rest;
        low.high[axis] = held.low[axis];
        high.low[axis] = held.high[axis];
        rest.low[axis] = held.low[axis];
        rest.high[axis] = held.high[axis];
        slabs.insert(slabs.end(), {low, high});
    }
    return slabs;
}

// Looks closer about what is small, a few times.
std::vector<Box> closer(Cover& covering, const Box& everywhere, std::vector<Box> boxes,
                        int levels) {
    constexpr int turns = 6;
    Box whole = everywhere;
    for (int turn = 1; turn < turns && !boxes.empty(); ++turn) {
        Box about = boxes.front();
        for (const Box& box : boxes) about = hull(about, box);
        const glm::dvec3 before = whole.high - whole.low, now = about.high - about.low;
        if (std::max({now.x, now.y, now.z}) > 0.3 * std::max({before.x, before.y, before.z})) break;
        whole = about;
        boxes = covering.of({about}, levels);
    }
    return boxes;
}

// Where a surface lies at some values.
struct Place {
    std::vector<Box> boxes;
    bool goes_on = false; // or may lie elsewhere, too
};

// Adds what lies beyond the reach that holds a first part, where it is plainly another part.
void add_beyond(double held, const formula::Program& program, const Values& values,
                double operations, Place& place) {
    constexpr int levels = 6;
    Cover covering(program, values, operations);
    for (double reach = held * FoundBounds::wider; reach <= FoundBounds::farthest;
         held = reach, reach *= FoundBounds::wider) {
        const Box everywhere = about_origin(reach);
        const std::vector<Box> slabs = beyond(about_origin(held), everywhere);
        const std::vector<Box> coarse = covering.of(slabs, levels);
        if (coarse.empty()) continue;
        const bool is_apart = std::ranges::none_of(
            coarse, [&](const Box& box) { return reaches_out(box, everywhere); });
        const std::vector<Box> more =
            is_apart ? covering.of(coarse, levels) : std::vector<Box>{}; // close enough for signs
        place.goes_on = !is_apart || covering.was_cut_short() ||
                        (!more.empty() && !covering.changes_sign(more));
        if (place.goes_on) return;
        place.boxes.insert(place.boxes.end(), more.begin(), more.end());
    }
}

// None where the work ended before boxes kept off the faces of the first reach.
std::optional<Place> place_of(const formula::Program& program, const Values& values,
                              double operations) {
    constexpr int levels = 6, levels_at_faces = 5;
    Cover covering(program, values, operations);
    bool goes_on = false;
    for (double reach = FoundBounds::reach; reach <= FoundBounds::farthest;
         reach *= FoundBounds::wider) {
        const bool is_first = reach == FoundBounds::reach;
        const Box everywhere = about_origin(reach);
        const auto is_out = [&](const Box& box) { return reaches_out(box, everywhere); };
        // Most surfaces that go on are told by the faces, which are fewer boxes.
        goes_on = !is_first && !covering.of({everywhere}, levels_at_faces, is_out).empty();
        if (goes_on) continue;
        std::vector<Box> boxes = covering.of({everywhere}, levels);
        goes_on = std::ranges::any_of(boxes, is_out);
        if (goes_on && covering.was_cut_short() && is_first) return std::nullopt;
        if (goes_on || boxes.empty()) continue;
        Place place{closer(covering, everywhere, std::move(boxes), levels)};
        add_beyond(reach, program, values, operations, place);
        return place;
    }
    return Place{{}, goes_on};
}

// A radius that a person would write, and no smaller one.
double rounded_up(double radius) {
    const double unit = std::pow(10.0, std::floor(std::log10(radius)) - 1);
    return std::ceil(radius / unit) * unit;
}

} // namespace

bool are_bounds_found(const Scene& scene) {
    return std::ranges::any_of(scene.surfaces,
                               [](const Surface& each) { return each.found_bounds.has_value(); });
}

std::optional<FoundBounds> find_bounds(const OneSurface& one) {
    const formula::Program& program = formula::value_enclosure(*one.surface.field);
    const auto values = values_of_frames(one);
    if (!values) return std::nullopt;
    std::vector<Box> all;
    bool goes_on = false;
    for (const Values& some : *values) {
        const auto place = place_of(program, some, most_evaluated / double(values->size()));
        if (!place) return std::nullopt;
        if (place->goes_on && place->boxes.empty()) return FoundBounds{};
        goes_on = goes_on || place->goes_on;
        all.insert(all.end(), place->boxes.begin(), place->boxes.end());
    }
    if (all.empty()) return FoundBounds{};
    Box about = all.front();
    for (const Box& box : all) about = hull(about, box);
    FoundBounds found;
    found.is_about_surface = !goes_on;
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

} // namespace isomotion::probe
