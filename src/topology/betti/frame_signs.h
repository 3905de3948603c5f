// A frame's solid on a grid, by numbers: fast, and no proof.
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
#include "topology/field/solid.h"

namespace isomotion::topology {

// What a caller has for it: operations, all elements of sums counted, and patience.
class Work {
public:
    // `stopped` may be asked by any thread.
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

// Vertices from one corner of the bounds' box to the other, `side` (at least 2) in each direction.
// No vertex outside of the bounds is solid, and none where F is 0 or no number. `threads`: 0 for as
// many as the machine runs at once.
SignGrid frame_signs(const formula::Field& field, const formula::Bindings<double>& bindings,
                     const scene::BoundsAt& bounds, Side solid, int side, int threads = 0);

struct SignEvaluators;

// Signs of many frames of one field, which must outlive this.
class FrameSigns {
public:
    // Takes how many elements each array has: where a grid finds the elements of one by place, a
    // frame takes no longer for those that are elsewhere.
    FrameSigns(const formula::Field& field, std::span<const int> elements_of_arrays);
    explicit FrameSigns(const formula::Field& field)
        : FrameSigns(field, {}) {}
    ~FrameSigns();

    // As frame_signs(). Adds what it takes to `work`; none where that is over. Whether it becomes
    // too much is the same for any number of threads.
    std::optional<SignGrid> at(const formula::Bindings<double>& bindings,
                               const scene::BoundsAt& bounds, Side solid, int side, int threads,
                               Work& work) const;
    // The same signs.
    std::optional<SignGrid> at(const scene::SceneAt& now, Side solid, int side, int threads,
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
    // For one thread, and for another frame afterwards: those of long programs have megabytes of
    // registers, and the system takes longer to give them than most frames take.
    std::unique_ptr<SignEvaluators, GiveBack> borrow() const;

    const formula::Field& field_;
    formula::Program enclosure_;
    std::optional<elements::FieldByPlace> by_place_;
    mutable std::mutex mutex_; // of what follows
    mutable std::vector<std::unique_ptr<SignEvaluators>> idle_;
};

} // namespace isomotion::topology
