#include "probe/sight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "formula/enclosure.h"
#include "formula/interval/prune.h"
#include "probe/sample_points.h"
#include "probe/thresholds.h"
#include "probe/unbounded.h"

namespace isomotion::probe {
namespace {

using scene::BoundsAt, scene::Bounds, scene::Camera, scene::OneSurface, scene::OneSurfaceAt,
    scene::SectionAt;

using formula::Interval, formula::Judged;

constexpr double most_operations = 2e7;
constexpr int fewest_points = 128; // of faces, to tell whether a surface ends within them

BoundsAt enlarged(BoundsAt bounds, double factor) {
    const glm::dvec3 middle = 0.5 * (bounds.min + bounds.max);
    bounds.min = middle + factor * (bounds.min - middle);
    bounds.max = middle + factor * (bounds.max - middle);
    bounds.radius *= factor;
    return bounds;
}

// The k-th place of a sequence that covers the faces evenly.
glm::dvec3 on_faces(const BoundsAt& bounds, int k) {
    const double u = halton(k, 2), v = halton(k, 3);
    if (bounds.shape == Bounds::Shape::sphere) {
        const double z = 2 * u - 1, r = std::sqrt(1 - z * z), a = 2 * std::numbers::pi * v;
        return bounds.centre + bounds.radius * glm::dvec3(r * std::cos(a), r * std::sin(a), z);
    }
    const int axis = k % 3;
    glm::dvec3 at(0);
    at[axis] = (k / 3) % 2;
    at[(axis + 1) % 3] = u;
    at[(axis + 2) % 3] = v;
    return bounds.min + at * (bounds.max - bounds.min);
}

// Whether a section takes a place of the world away.
bool is_cut_off(const OneSurfaceAt& now, const glm::dvec3& world) {
    return std::ranges::any_of(now.scene.sections,
                               [&](const SectionAt& section) { return section.value(world) > 0; });
}

// F's values, if intervals keep them off 0 everywhere in the bounds.
class Enclosing {
public:
    Enclosing(const formula::Program& value, const OneSurfaceAt& now, double evaluations)
        : value_(value)
        , bindings_(formula::convert<Interval>(now.surface.bindings))
        , bounds_(now.surface.bounds)
        , left_(evaluations) {}

    std::optional<Interval> values() {
        constexpr double smallest = 0x1.01p-7; // 128 cells along each axis, but for rounding
        const glm::dvec3 &a = bounds_.min, &b = bounds_.max;
        const std::array whole{Interval{a.x, b.x}, Interval{a.y, b.y}, Interval{a.z, b.z}};
        const bool keeps_off_0 = prune(whole, [&](const std::array<Interval, 3>& box) {
            if (is_outside(box) || tells_sign(box)) return Judged::settled;
            const bool is_small = longest_side(box, whole).part <= smallest;
            return is_small || (left_ -= 2) < 0 ? Judged::refused : Judged::open;
        });
        return keeps_off_0 ? all_ : std::nullopt;
    }

private:
    bool is_outside(const std::array<Interval, 3>& box) const {
        if (bounds_.shape != Bounds::Shape::sphere) return false;
        Interval off = 0;
        for (int k = 0; k < 3; ++k) {
            const Interval d = box[std::size_t(k)] - Interval(bounds_.centre[k]);
            off = off + d * d;
        }
        return off.lo > bounds_.radius * bounds_.radius;
    }

    bool tells_sign(const std::array<Interval, 3>& box) {
        Interval f;
        value_.point(bindings_, box, {&f, 1});
        if (!(f.lo > 0 || f.hi < 0)) return false;
        all_ = all_ ? hull(*all_, f) : f;
        return true;
    }

    formula::Evaluator<Interval> value_;
    formula::Bindings<Interval> bindings_;
    BoundsAt bounds_;
    double left_;
    std::optional<Interval> all_;
};

} // namespace

Sight sight(const OneSurface& one, const OneSurfaceAt& now) {
    const formula::Field& field = *one.surface.field;
    const std::vector<int> counts = now.surface.bindings.counts();
    const double evaluations =
        most_operations / (formula::cost(field.value, counts).operations + 1);
    const int points = int(std::clamp(evaluations, 2.0, 2048.0));

    formula::Evaluator<double> evaluate(field.value);
    const auto bindings = formula::convert<double>(now.surface.bindings);
    // All together: sums over very many elements take a fraction of the time.
    const auto f_at = [&](const std::vector<glm::dvec3>& places) {
        std::array<std::vector<double>, 3> at;
        for (const glm::dvec3& p : places) {
            for (int axis = 0; axis < 3; ++axis) at[std::size_t(axis)].push_back(p[axis]);
        }
        std::vector<double> values(places.size());
        const std::array<std::span<const double>, 3> from{at[0], at[1], at[2]};
        evaluate.points(bindings, from, std::array{std::span(values)});
        for (double& f : values) f /= field.scale;
        return values;
    };
    Sight found;
    found.least = HUGE_VAL;
    found.most = -HUGE_VAL;
    const auto tell = [&](double f) {
        if (f < found.least) found.least = f;
        if (f > found.most) found.most = f;
    };
    // The part of places on faces where F is below 0, among those where it has a value; nothing if
    // it has one at none.
    const auto below_0 = [&](const BoundsAt& bounds, auto&& take) -> std::optional<double> {
        int below = 0, known = 0;
        std::vector<glm::dvec3> places;
        for (int k = 1; k <= points; ++k) places.push_back(on_faces(bounds, k));
        for (const double f : f_at(places)) {
            known += !std::isnan(f);
            below += f < 0;
            take(f);
        }
        if (known == 0) return std::nullopt;
        return double(below) / known;
    };
    std::vector<glm::dvec3> inside;
    for (int k = 1; k <= points; ++k) {
        const glm::dvec3 p = sample_point(now.surface.bounds, k);
        if (is_in(now.surface.bounds, p)) inside.push_back(p);
    }
    int in_solid = 0, left = 0;
    const std::vector<double> values = f_at(inside);
    for (std::size_t k = 0; k < values.size(); ++k) {
        tell(values[k]);
        if (!(values[k] < 0)) continue;
        ++in_solid;
        left += !is_cut_off(now, now.surface.placement.to_world(inside[k]));
    }
    found.is_cut_away = in_solid > 0 && left == 0;
    const double below = below_0(now.surface.bounds, tell).value_or(0);
    found.changes_sign = found.least < 0 && found.most > 0;
    found.cut = std::min(below, 1 - below);
    const auto ends_within = [&](double factor) {
        const auto part = below_0(enlarged(now.surface.bounds, factor), [](double) {});
        return part && (*part == 0 || *part == 1);
    };
    bool has_end = found.cut == 0 && points >= fewest_points;
    for (const double factor : {1.1, 1.25, 1.5, 2.0, 3.0}) {
        if (has_end) break;
        if (points < fewest_points) break;
        has_end = ends_within(factor);
        if (has_end && !one.surface.material.inside) found.closed_by = factor;
    }
    found.unbounded = why_unbounded(one, now.surface);
    if (!found.changes_sign) {
        found.values =
            Enclosing(formula::enclosure_programs(field).value, now, evaluations).values();
        if (found.values)
            found.values = Interval{found.values->lo / field.scale, found.values->hi / field.scale};
    }
    const glm::dvec3 eye = now.surface.placement.to_local(now.scene.camera.position);
    const bool is_perspective = now.scene.camera.projection == Camera::Projection::perspective;
    const bool is_outside = is_cut_off(now, now.scene.camera.position);
    if (is_perspective && is_in(now.surface.bounds, eye) && has_end && !is_outside) {
        const double at_eye = f_at({eye})[0];
        found.eye_in_solid = below > 0.5 ? at_eye > 0 : at_eye < 0;
    }
    const auto& origin = field.origin.point;
    // A 64th of a pixel of a picture 512 pixels high.
    constexpr double visible = 0x1p-14;
    const bool is_moved = origin != std::array<double, 3>{};
    const scene::BoundsAt& bounds = now.surface.bounds;
    const double displacement = is_moved ? float32_displacement(field, now.surface) : 0;
    if (is_far(bounds) || (displacement > visible && std::isfinite(displacement)))
        found.far_middle = bounds.centre + glm::dvec3(origin[0], origin[1], origin[2]);
    return found;
}

std::string why_nothing_is_seen(const Sight& sight) {
    if (sight.values)
        return fmt::format(
            "there is no surface: F is {:.4g} to {:.4g} everywhere within the bounds",
            sight.values->lo, sight.values->hi);
    if (sight.is_cut_away)
        return "the sections take all of the solid away, where F < 0, at the points that were "
               "tried";
    if (sight.unbounded) return "F has no value or may jump at every point that was tried";
    if (sight.changes_sign)
        return "F changes its sign within the bounds, but no ray meets a zero there: the camera "
               "looks elsewhere, or F jumps or has a pole";
    if (sight.least > sight.most) return "F is no number at any point of the bounds that was tried";
    return fmt::format("F is {:.4g} to {:.4g} at the points of the bounds that were tried",
                       sight.least, sight.most);
}

std::vector<std::string> slips(const Sight& sight) {
    std::vector<std::string> told;
    if (sight.unbounded) told.push_back(*sight.unbounded);
    if (sight.eye_in_solid) told.emplace_back("the camera stands inside the solid");
    if (sight.closed_by)
        told.push_back(fmt::format("the bounds cut the surface open: {:.2g} % of their faces are "
                                   "inside the solid; bounds {:g} times as large would close it; a "
                                   "back_color says that it is meant",
                                   100 * sight.cut, *sight.closed_by));
    if (sight.far_middle) {
        const glm::dvec3& to = *sight.far_middle;
        told.push_back(fmt::format(
            "the bounds lie so far from the origin that floats leave edges ragged; write the "
            "formula about the origin, and move it by transform = {{ translate = [{}, {}, {}] }}",
            to.x, to.y, to.z));
    }
    return told;
}

} // namespace isomotion::probe
