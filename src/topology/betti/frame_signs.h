// Samples a frame's solid on a grid, in numbers: fast, without proof.
#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "elements/field_by_place.h"
#include "scene/scene_at.h"
#include "topology/betti/sign_grid.h"
#include "topology/field/frame_field.h"
#include "topology/field/solid.h"

namespace isomotion::topology {

// A budget of operations, counted with all elements of sums, and a request to stop.
class Work {
public:
    // Any thread may call `stopped`.
    explicit Work(std::function<bool()> stopped = {},
                  double most = std::numeric_limits<double>::infinity())
        : stopped_(std::move(stopped))
        , most_(most) {}
    void add(double operations) { done_.fetch_add(operations, std::memory_order_relaxed); }
    double done() const { return done_.load(std::memory_order_relaxed); }
    bool is_too_much() const { return done() > most_; }
    bool is_over() const { return is_too_much() || (stopped_ && stopped_()); }

private:
    std::function<bool()> stopped_;
    double most_;
    std::atomic<double> done_ = 0;
};

// Vertices from one corner of the bounds' box to the other, `side` (at least 2) in each direction;
// in a ball those of the cube that it is taken for (ball_as_cube.h). A vertex is not solid if F
// there is 0 or NaN. `threads`: 0 for as many as the machine runs at once.
SignGrid frame_signs(const formula::Field& field, const formula::Bindings<double>& bindings,
                     const scene::BoundsAt& bounds, Side solid, int side, int threads = 0);

// The same of a formula that is no scene's, in intervals, vertex by vertex: slow where it has many
// elements. A vertex whose sign is not certain is not solid.
SignGrid frame_signs(const SpaceFormula& formula, const scene::BoundsAt& bounds, int side);

struct SignEvaluators;

// Signs of many frames of one field, which must outlive this.
class FrameSigns {
public:
    // Takes the number of elements of each array. If a grid finds the elements of one array by
    // place, elements elsewhere don't add to a frame's time.
    FrameSigns(const formula::Field& field, std::span<const int> elements_of_arrays);
    explicit FrameSigns(const formula::Field& field)
        : FrameSigns(field, {}) {}
    ~FrameSigns();

    // Finds what frame_signs() finds. Adds its operations to `work`; none if that is over. Whether
    // the work becomes too much is the same for any number of threads.
    std::optional<SignGrid> at(const formula::Bindings<double>& bindings,
                               const scene::BoundsAt& bounds, Side solid, int side, int threads,
                               Work& work) const;
    // The same for a surface at a time.
    std::optional<SignGrid> at(const scene::SurfaceAt& now, Side solid, int side, int threads,
                               Work& work) const;

private:
    std::optional<SignGrid> make(const formula::Bindings<double>& bindings,
                                 const elements::FieldByPlace::Frame* by_place,
                                 const scene::BoundsAt& bounds, Side solid, int side, int threads,
                                 Work& work) const;
    struct GiveBack {
        const FrameSigns* to;
        void operator()(SignEvaluators* evaluators) const;
    };
    // Evaluators for one thread, reused for later frames. For long programs they have megabytes of
    // registers, whose allocation takes longer than most frames.
    std::unique_ptr<SignEvaluators, GiveBack> borrow() const;

    const formula::Field& field_;
    formula::Program enclosure_;
    std::optional<elements::FieldByPlace> by_place_;
    mutable std::mutex mutex_; // guards the members below
    mutable std::vector<std::unique_ptr<SignEvaluators>> idle_;
};

} // namespace isomotion::topology
