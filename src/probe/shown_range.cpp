#include "probe/shown_range.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include "formula/curvature.h"
#include "formula/element_weights.h"
#include "scene/error.h"
#include "scene/near_elements.h"
#include "scene/rays.h"

namespace isomotion::probe {
namespace {

using scene::BoundsAt, scene::Bounds, scene::ElementFinder, scene::NearElements, scene::OneSurface,
    scene::OneSurfaceAt, scene::Range, scene::Rays, scene::SceneAt, scene::SceneError,
    scene::SectionAt;

// What looking takes.
struct Effort {
    static constexpr int most_frames = 9, fewest_frames = 3;
    static constexpr int most_across = 40, fewest_across = 6; // rays of a picture's longer side
    static constexpr int pieces = 64;                         // of a ray's way through the bounds
    static constexpr int parts = 32; // of a piece that a root is in, and of these again
    static constexpr int rounds = 3;
    static constexpr double operations = 2e9;        // in all, as near as that can be told
    static constexpr double most_operations = 4e9;   // of the fewest rays
    static constexpr double most_values = 1e6;       // of elements, in all frames
    static constexpr double most_to_have_them = 3e7; // operations, in all frames
};

struct Way {
    glm::dvec3 anchor{0}, direction{0};
    double near = 1, far = 0;

    glm::dvec3 at(double t) const { return anchor + t * direction; }
};

// The part of a ray within the bounds and before the eye.
Way way_of(const Rays& rays, const BoundsAt& bounds, double u, double v) {
    const glm::dvec3 across = u * rays.right + v * rays.up;
    const glm::dvec3 from_eye = rays.parallel ? rays.axis : rays.axis + across;
    Way way{rays.origin + across, glm::normalize(from_eye)};
    const double eye = -glm::length(from_eye);
    if (bounds.shape == Bounds::Shape::sphere) {
        const glm::dvec3 from = way.anchor - bounds.centre;
        const double middle = -glm::dot(from, way.direction);
        const double foot = glm::length(from + middle * way.direction);
        if (!(foot < bounds.radius)) return way;
        const double half = std::sqrt(bounds.radius * bounds.radius - foot * foot);
        way.near = std::max(middle - half, eye);
        way.far = middle + half;
        return way;
    }
    way.near = eye;
    way.far = HUGE_VAL;
    for (int k = 0; k < 3; ++k) {
        // Parallel to the sides: at once infinite, or no number, which both comparisons pass by.
        const double a = (bounds.min[k] - way.anchor[k]) / way.direction[k];
        const double b = (bounds.max[k] - way.anchor[k]) / way.direction[k];
        way.near = std::max(way.near, std::min(a, b));
        way.far = std::min(way.far, std::max(a, b));
    }
    return way;
}

// A place on a ray, and the section on whose cap it is.
struct Met {
    double t = 0;
    std::optional<int> cap;
};

// The scene at one time, as a ray meets it.
class MetSurface {
public:
    MetSurface(const OneSurface& one, const formula::Paint& paint, const OneSurfaceAt& now,
               NearElements& elements, bool paint_sums_all)
        : value_(one.surface.field->value)
        , field_(*one.surface.field)
        , paint_(paint.value)
        , now_(now)
        , elements_(elements)
        , paint_sums_all_(paint_sums_all) {
        if (paint.hessian) hessian_.emplace(*paint.hessian);
        for (const SectionAt& section : now.scene.sections)
            sections_.push_back(in_formula_coordinates(section, now.surface.placement));
    }

    // The first hit that the sections leave visible.
    std::optional<Met> met(const Way& way) {
        if (sections_.empty()) {
            const auto t = root(way);
            return t ? std::optional(Met{*t, {}}) : std::nullopt;
        }
        for (const scene::PartLeft& part :
             parts_left(sections_, way.anchor, way.direction, way.near, way.far)) {
            if (part.begin_cut && value(way, part.begin) < 0)
                return Met{part.begin, part.begin_cut};
            if (const auto t = root({way.anchor, way.direction, part.begin, part.end}))
                return Met{*t, {}};
            if (part.end_cut && value(way, part.end) < 0) return Met{part.end, part.end_cut};
        }
        return std::nullopt;
    }

    double number(const Way& way, const Met& met) {
        const glm::dvec3 p = way.at(met.t);
        const std::array<double, 3> at{p.x, p.y, p.z};
        const auto& bindings = elements_.at(p);
        std::array<double, 3> g = field_.gradient(bindings, at);
        formula::Curvatures curved;
        if (met.cap) {
            const SectionAt& section = sections_[std::size_t(*met.cap)];
            const glm::dvec3 of_section = section.gradient(p);
            g = {of_section.x, of_section.y, of_section.z};
            if (section.is_ball) curved = {-1 / section.reach, 1 / (section.reach * section.reach)};
        } else if (hessian_) {
            std::array<double, 6> second{};
            hessian_->point(bindings, at, second);
            curved = formula::curvatures(g, second);
        }
        const glm::dvec3 n =
            glm::normalize(now_.surface.placement.rotate * glm::dvec3(g[0], g[1], g[2]));
        const std::array<double, 10> inputs{
            // paint_names
            p.x, p.y, p.z, n.x, n.y, n.z, curved.mean, curved.gaussian, 0, now_.scene.time};
        double number = 0;
        paint_.point(paint_sums_all_ ? elements_.all() : bindings, inputs, {&number, 1});
        return number;
    }

private:
    // Where F first changes its sign along the way, other than at a pole.
    std::optional<double> root(const Way& way) {
        const std::vector<double> f = values(way, way.near, way.far, Effort::pieces);
        const double piece = (way.far - way.near) / Effort::pieces;
        for (std::size_t k = 0; k + 1 < f.size(); ++k) {
            if (!changes(f[k], f[k + 1])) continue;
            if (const auto found =
                    root_in(way, way.near + double(k) * piece, piece, f[k], f[k + 1]))
                return found;
        }
        return std::nullopt;
    }

    double value(const Way& way, double t) { return values(way, t, t, 0).front(); }

    static bool changes(double f, double next) { return f * next <= 0 && f != 0; }

    std::optional<double> root_in(const Way& way, double low, double length, double f_low,
                                  double f_high) {
        const double smaller = std::min(std::abs(f_low), std::abs(f_high));
        const double larger = std::max(std::abs(f_low), std::abs(f_high));
        double there = f_low;
        for (int round = 0; round < Effort::rounds; ++round) {
            const std::vector<double> f = values(way, low, low + length, Effort::parts);
            std::size_t k = 0;
            while (k + 2 < f.size() && !changes(f[k], f[k + 1])) ++k;
            length /= Effort::parts;
            low += double(k) * length;
            there = f[k];
        }
        // Towards a pole values grow.
        return std::abs(there) <= std::max(smaller, 1e-3 * larger) ? std::optional(low)
                                                                   : std::nullopt;
    }

    // Values at the ends of equal parts of the way from `low` to `high`.
    std::vector<double> values(const Way& way, double low, double high, int parts) {
        std::array<std::vector<double>, 3> places;
        for (int k = 0; k <= parts; ++k) {
            const glm::dvec3 p = way.at(low + (high - low) * k / std::max(parts, 1));
            for (int axis = 0; axis < 3; ++axis) places[std::size_t(axis)].push_back(p[axis]);
        }
        std::vector<double> found(places[0].size());
        if (!elements_.is_by_place()) {
            const std::array<std::span<const double>, 3> inputs{places[0], places[1], places[2]};
            const std::array<std::span<double>, 1> outputs{found};
            value_.points(elements_.all(), inputs, outputs);
            return found;
        }
        for (std::size_t k = 0; k < found.size(); ++k) {
            const std::array<double, 3> p{places[0][k], places[1][k], places[2][k]};
            value_.point(elements_.at({p[0], p[1], p[2]}), p, {&found[k], 1});
        }
        return found;
    }

    formula::Evaluator<double> value_;
    formula::FieldEvaluator<double> field_;
    formula::Evaluator<double> paint_;
    std::optional<formula::Evaluator<double>> hessian_;
    const OneSurfaceAt now_;
    NearElements& elements_;
    bool paint_sums_all_;
    std::vector<SectionAt> sections_; // formula coordinates
};

double work(const formula::Program& program, std::span<const int> counts) {
    constexpr double of_a_function = 10; // exp, sin, ...
    const formula::Cost cost = formula::cost(program, counts);
    return cost.operations + of_a_function * cost.functions;
}

// Rays on the longer side of a picture, so many that all frames take what there is to spend.
int rays_across(const OneSurface& one, const formula::Paint& paint, const NearElements& elements,
                bool paint_sums_all, int frames) {
    const std::vector<int> usual = elements.usual_counts();
    const std::vector<int> all = elements.all().counts();
    const formula::Field& field = *one.surface.field;
    constexpr int values = Effort::pieces + Effort::rounds * Effort::parts;
    double each = values * work(field.value, usual) + work(field.gradient, usual) +
                  work(paint.value, paint_sums_all ? all : usual);
    if (paint.hessian) each += work(*paint.hessian, usual);
    const double rays = Effort::operations / frames / (each + 1);
    constexpr double fewest = Effort::fewest_across * Effort::fewest_across;
    if (rays < fewest * Effort::operations / Effort::most_operations)
        throw NoRange("what the surface shows takes too long to find; give [low, high]");
    return std::clamp(int(std::sqrt(rays)), Effort::fewest_across, Effort::most_across);
}

int frames_to_show(const OneSurface& one) {
    const animation::Animation& animation = one.surface.animation;
    double values = 0, operations = animation.operations();
    for (std::size_t a = 0; a < animation.arrays().size(); ++a) {
        values += animation.values(a);
        operations += animation.operations(a);
    }
    if (operations * Effort::fewest_frames > 2 * Effort::most_to_have_them)
        throw NoRange("what the surface shows takes too long to find; give [low, high]");
    const double by_operations = Effort::most_to_have_them / (operations + 1);
    const int frames = int(std::clamp(std::min(Effort::most_values / (values + 1), by_operations),
                                      double(Effort::fewest_frames), double(Effort::most_frames)));
    return std::min(frames, one.scene.timeline.frames);
}

// One end of the numbers of a picture, and the ray that shows it.
struct End {
    double sign = 1;                                         // of the greatest; -1 of the least
    double value = -std::numeric_limits<double>::infinity(); // times the sign
    glm::dvec2 at{0};                                        // picture coordinates

    bool take(double number, const glm::dvec2& where) {
        if (!(std::abs(number) < double(std::numeric_limits<float>::max()))) return false;
        if (!(sign * number > value)) return false;
        value = sign * number;
        at = where;
        return true;
    }
};

// The rays of a picture.
class Pictured {
public:
    Pictured(MetSurface& surface, const Rays& rays, const BoundsAt& bounds)
        : surface_(surface)
        , rays_(rays)
        , bounds_(bounds) {}

    double number(const glm::dvec2& at) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        const Way way = way_of(rays_, bounds_, at.x, at.y);
        if (!(way.near < way.far)) return none;
        const auto met = surface_.met(way);
        if (!met) return none;
        met_ = true;
        return surface_.number(way, *met);
    }

    bool met() const { return met_; }

    void scan(int width, int height, std::span<End> ends) {
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column) {
                const glm::dvec2 at((2 * column + 1.0) / width - 1, (2 * row + 1.0) / height - 1);
                const double found = number(at);
                for (End& end : ends) end.take(found, at);
            }
        }
    }

    // Looks around it, ever nearer, from half a pixel on: extremes lie on silhouettes.
    void climb(End& end, glm::dvec2 pixel, int rounds) {
        if (!std::isfinite(end.value)) return;
        for (int k = 0; k < rounds; ++k) {
            pixel *= 0.5;
            const glm::dvec2 middle = end.at;
            for (const glm::dvec2& step :
                 {glm::dvec2(1, 0), {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}) {
                const glm::dvec2 at = glm::clamp(middle + step * pixel, -1.0, 1.0);
                end.take(number(at), at);
            }
        }
    }

private:
    MetSurface& surface_;
    const Rays rays_;
    const BoundsAt& bounds_;
    bool met_ = false;
};

// Widens the range by what a frame shows. Whether a ray met the surface.
bool look(const OneSurface& one, const formula::Paint& paint, bool sums_all,
          const ElementFinder& finder, int frame, int frames, Range& range) {
    const SceneAt scene = at_frame(one.scene, frame);
    const OneSurfaceAt now(scene, one.index);
    NearElements elements(finder, now.surface);
    const int longer = rays_across(one, paint, elements, sums_all, frames);
    const int most = std::max(one.scene.output.width, one.scene.output.height);
    const int width = std::max(1, longer * one.scene.output.width / most);
    const int height = std::max(1, longer * one.scene.output.height / most);
    MetSurface surface(one, paint, now, elements, sums_all);
    Pictured picture(surface, rays(now, one.scene.output.width, one.scene.output.height),
                     now.surface.bounds);
    std::array<End, 2> ends{End{-1}, End{1}};
    picture.scan(width, height, ends);
    // A spike goes on and on: what is added stays small beside what many rays show.
    constexpr double most_added = 0.125;
    const double added = most_added * (ends[0].value + ends[1].value);
    for (End& end : ends) {
        const double scanned = end.value;
        picture.climb(end, glm::dvec2(2.0 / width, 2.0 / height), std::min(8, longer / 4));
        end.value = std::min(end.value, scanned + added);
    }
    range.least = std::min(range.least, -ends[0].value);
    range.most = std::max(range.most, ends[1].value);
    return picture.met();
}

} // namespace

ShownRange shown_range(const OneSurface& one, const formula::Paint& paint) {
    const ElementFinder finder(one);
    const int frames = frames_to_show(one);
    const auto array = finder.array();
    const bool sums_all =
        array && !formula::weigh_like_field(paint.graph, paint.field, paint.roots, *array);
    Range none;
    Range range{none.most, none.least};
    bool met = false;
    for (int k = 0; k < frames; ++k) {
        const int frame =
            1 + int(std::int64_t(one.scene.timeline.frames - 1) * k / std::max(1, frames - 1));
        try {
            met = look(one, paint, sums_all, finder, frame, frames, range) || met;
        } catch (const SceneError&) { // said where the frame is drawn, as is the other
        } catch (const std::length_error&) {
        }
    }
    if (!met) return {{0, 1}, false};
    if (!(range.least <= range.most)) {
        throw NoRange("the value is no finite number anywhere on the surface, as far as rays of "
                      "small pictures show; mend it, or give [low, high]");
    }
    if (float(range.least) < float(range.most)) return {range};
    const double half = 0.5 * std::max(1.0, std::abs(range.least));
    return {{range.least - half, range.least + half}};
}

} // namespace isomotion::probe
