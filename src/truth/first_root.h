// The first root of the field along a ray, enclosed by interval arithmetic (Moore 1966; Mitchell
// 1990): every statement holds for all rays of the tube.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "elements/field_by_place.h"
#include "formula/enclosure.h"
#include "scene/scene_at.h"
#include "truth/tube.h"

namespace isomotion::truth {

enum class Answer : std::uint8_t {
    miss,      // no root, and no cap
    hit,       // the first root is in [low, high], a simple one, and nothing touches zero before;
               // or the first of what sections leave is a cap there
    touching,  // before what `after` says there may be roots in [touch_low, touch_high]: of even
               // order, or a change of sign that may be a jump or a pole
    undecided, // the budget of evaluations ended; no root before `low`
};

struct FirstRoot {
    Answer answer = Answer::miss;
    bool after_is_hit = false; // of a touching one: a certain root in [low, high], else a miss
    float low = 0, high = 0;   // rounded outward
    float touch_low = 0, touch_high = 0;
    // Gradient of F in the middle of a hit's enclosure, where gradients() was asked for; 0: not
    // known.
    std::array<float, 3> gradient{};
    std::int32_t cap = -1;    // the section on whose cap a hit is, see cut_rays.h
    std::int32_t surface = 0; // of several, that a hit is on; -1: not known, see nearest.h
};

struct Budget {
    int evaluations = 20'000; // of the field, for one ray
    // The shortest pieces that are told from zero, in footprints: where the sign is unknown at an
    // end of them, and where it is known at both.
    double narrow = 0x1p-5, narrowest = 0x1p-20;
    double bracket = 1e-3; // width of a hit's enclosure, in footprints
};

// Finds roots for many rays, evaluating them together. One a thread.
class RootFinder {
public:
    RootFinder(const formula::EnclosurePrograms& field, const scene::SceneAt& scene,
               Budget budget = {});
    // With sums over the elements that matter at each place: of many elements.
    explicit RootFinder(const elements::FieldByPlace::Frame& field, Budget budget = {});

    void find(std::span<const Tube> tubes, std::span<FirstRoot> roots);
    // The signs of F over the whole tubes, from `near` to `far`: 0 where it may be 0 or has no
    // value.
    std::vector<int> signs(std::span<const Tube> tubes);
    // Finds the gradients of the hits among them but caps.
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
    formula::Bindings<formula::Interval> bindings_; // of programs over all elements
    bool may_lack_values_;
    Budget budget_;
    std::int64_t evaluations_ = 0;
};

} // namespace isomotion::truth
