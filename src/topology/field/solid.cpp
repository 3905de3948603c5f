#include "topology/field/solid.h"

#include <algorithm>
#include <vector>

#include "formula/enclosure.h"
#include "formula/evaluate/evaluate.h"
#include "scene/scene_at.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

constexpr int per_face = 64; // intervals in each direction
constexpr int smallest = 8;  // of a patch

// A formula that takes more at all points is asked at fewer.
constexpr double most_operations = 5e8;

// Points `u` to `u + side` and `v` to `v + side` of a face, 0 to 5.
struct Patch {
    int face, u, v, side;
};

class FaceSigns {
public:
    FaceSigns(const formula::Field& field, const scene::SurfaceAt& now)
        : numbers_(formula::convert<double>(now.bindings))
        , intervals_(formula::convert<Interval>(now.bindings))
        , bounds_(now.bounds)
        , value_(field.value)
        , enclosure_program_(formula::value_enclosure(field))
        , enclosure_(enclosure_program_) {
        const std::vector<int> counts = numbers_.counts();
        const formula::Cost cost = formula::cost(field.value, counts);
        of_point_ = 1 + cost.operations + 20 * cost.functions;
    }

    Side solid() {
        std::vector<Patch> open;
        open.reserve(6);
        for (int face = 0; face < 6; ++face) open.push_back({face, 0, 0, per_face});
        while (!open.empty()) {
            std::vector<Patch> quarters;
            for (const Patch& patch : open) {
                take_points(patch, patch.side);
                if (negative_ && positive_) return Side::negative;
                if (operations_ > most_operations || is_told(patch)) continue;
                if (patch.side == smallest) {
                    take_points(patch, 1);
                    continue;
                }
                const int half = patch.side / 2;
                for (int k = 0; k < 4; ++k) {
                    quarters.push_back(
                        {patch.face, patch.u + k % 2 * half, patch.v + k / 2 * half, half});
                }
            }
            open = std::move(quarters);
        }
        return negative_ && !positive_ ? Side::positive : Side::negative;
    }

private:
    // The sphere is the cube, blown up.
    glm::dvec3 point(int face, int i, int j) const {
        const int axis = face / 2;
        glm::dvec3 p;
        p[axis] = face % 2 ? 1 : -1;
        p[(axis + 1) % 3] = 2.0 * i / per_face - 1;
        p[(axis + 2) % 3] = 2.0 * j / per_face - 1;
        if (bounds_.shape == scene::Bounds::Shape::sphere)
            return bounds_.centre + bounds_.radius * glm::normalize(p);
        return 0.5 * (bounds_.min + bounds_.max) + 0.5 * p * (bounds_.max - bounds_.min);
    }

    // Every `step`th in both directions, the corners included.
    std::array<std::vector<double>, 3> points(const Patch& patch, int step) const {
        std::array<std::vector<double>, 3> all;
        for (int i = 0; i <= patch.side; i += step) {
            for (int j = 0; j <= patch.side; j += step) {
                const glm::dvec3 p = point(patch.face, patch.u + i, patch.v + j);
                for (int k = 0; k < 3; ++k) all[std::size_t(k)].push_back(p[k]);
            }
        }
        return all;
    }

    void take_points(const Patch& patch, int step) {
        const auto at = points(patch, step);
        std::vector<double> f(at[0].size());
        const std::array<std::span<const double>, 3> inputs{at[0], at[1], at[2]};
        const std::array<std::span<double>, 1> outputs{f};
        value_.points(numbers_, inputs, outputs);
        operations_ += of_point_ * double(f.size());
        for (double value : f) {
            negative_ |= value < 0;
            positive_ |= value > 0;
        }
    }

    // Whether an enclosure tells the sign at all of its points.
    bool is_told(const Patch& patch) {
        const auto at = points(patch, 1);
        std::array<Interval, 3> box;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::ranges::minmax(at[k]);
            box[k] = {low, high};
        }
        Interval f;
        enclosure_.point(intervals_, box, {&f, 1});
        operations_ += 3 * of_point_;
        negative_ |= f.hi < 0;
        positive_ |= f.lo > 0;
        return f.hi < 0 || f.lo > 0;
    }

    formula::Bindings<double> numbers_;
    formula::Bindings<Interval> intervals_;
    scene::BoundsAt bounds_;
    formula::Evaluator<double> value_;
    formula::Program enclosure_program_;
    formula::Evaluator<Interval> enclosure_;
    double of_point_ = 0, operations_ = 0;
    bool negative_ = false, positive_ = false; // values at points
};

} // namespace

Side solid_side(const scene::OneSurface& one) {
    const scene::SurfaceAt first = scene::surface_at(one, one.scene.timeline.time(1));
    return FaceSigns(*one.surface.field, first).solid();
}

} // namespace isomotion::topology
