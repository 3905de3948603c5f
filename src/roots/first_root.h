// Finds the first root of the field along a ray, enclosed by interval arithmetic (Moore 1966;
// Mitchell 1990). Every statement holds for all rays of the tube.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "elements/field_by_place.h"
#include "formula/enclosure.h"
#include "roots/tube.h"
#include "scene/scene_at.h"

namespace isomotion::roots {

enum class Answer : std::uint8_t {
    miss, // no root, and no cap
    hit,  // the first root is in [low, high], it is simple, and F doesn't touch zero before; or the
          // first surface that sections leave is a cap there
    touching,  // before the answer of `after_is_hit` there may be roots in [touch_low, touch_high]:
               // of even order, or a change of sign that may be a jump or a pole
    undecided, // the budget of evaluations was used up; no root before `low`
};

struct FirstRoot {
    Answer answer = Answer::miss;
    // For `touching`: then a certain root in [low, high]; false: then a miss.
    bool after_is_hit = false;
    float low = 0, high = 0; // rounded outward
    float touch_low = 0, touch_high = 0;
    // Gradient of F in the middle of a hit's enclosure, if gradients() was called; 0 if unknown.
    std::array<float, 3> gradient{};
    std::int32_t cap = -1;    // the section on whose cap the hit is, see cut_rays.h
    std::int32_t surface = 0; // index of the surface that was hit; -1: unknown, see nearest.h
};

struct Budget {
    int evaluations = 20'000; // of the field, per ray
    // The length, in footprints, below which pieces are no longer distinguished from zero: where
    // the sign is unknown at an end of the piece, and where it is known at both.
    double narrow = 0x1p-5, narrowest = 0x1p-20;
    double bracket = 1e-3; // width of a hit's enclosure, in footprints
};

// Finds roots for many rays, evaluating them together. Use one per thread.
class RootFinder {
public:
    RootFinder(const formula::EnclosurePrograms& field, const scene::SurfaceAt& surface,
               Budget budget = {});
    // For fields with many elements: sums over the elements that matter at each place.
    explicit RootFinder(const elements::FieldByPlace::Frame& field, Budget budget = {});

    void find(std::span<const Tube> tubes, std::span<FirstRoot> roots);
    // The signs of F over the whole tubes, from `near` to `far`; 0 where F may be 0 or has no
    // value.
    std::vector<int> signs(std::span<const Tube> tubes);
    // Computes the gradients for hits other than caps.
    void gradients(std::span<const Tube> tubes, std::span<FirstRoot> roots);

    std::int64_t evaluations() const { return evaluations_; }

private:
    struct Lane;
    struct Request;
    static constexpr std::size_t lanes_together = 64;

    void sharpen(std::vector<Lane>& lanes, Request& points);
    void sharpen(std::span<const std::size_t> uncertain, Request& points);
    void begin(Lane& lane, const formula::Interval& f) const;
    void resume(Lane& lane, const formula::Interval& f) const;
    void march(Lane& lane, const formula::Interval& at_b, const formula::Interval& f,
               const formula::Interval& slope);
    void refine(Lane& lane, const formula::Interval& f) const;
    void end_run(Lane& lane, int sign);
    struct Breaks {
        bool is_continuous = false, has_no_value = false;
    };
    Breaks breaks(const Tube& tube, double low, double high);
    void pass_gap(Lane& lane, const formula::Interval& at_b) const;
    void finish(Lane& lane) const;

    using OverAll = formula::Evaluator<formula::Interval>;
    using Program = std::variant<OverAll, elements::BoxesByPlace>;

    Program value_, directional_, gradient_, jumps_;
    formula::Bindings<formula::Interval> bindings_; // for programs over all elements
    bool may_lack_values_;
    Budget budget_;
    std::int64_t evaluations_ = 0;
};

} // namespace isomotion::roots
