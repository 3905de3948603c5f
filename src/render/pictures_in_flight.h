// Pictures that were started and not taken yet, in order: each with its pixels in transfer, or
// already drawn.
#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "gpu/transfer.h"
#include "render/renderer.h"

namespace isomotion::render {

struct PictureInFlight {
    PictureInputs inputs;                  // what it is drawn from
    std::optional<gpu::Transfer> pixels;   // in transfer
    std::optional<Picture> picture;        // or already drawn
    std::chrono::duration<double> begun{}; // the time that starting took
};

class PicturesInFlight {
public:
    int count() const { return int(flights_.size()); }
    // Throws std::logic_error if there are more.
    void expect_at_most(int most) const {
        if (count() <= most) return;
        throw std::logic_error(
            fmt::format("{} pictures that were asked for are not taken yet", count()));
    }

    void add(PictureInFlight flight) { flights_.push_back(std::move(flight)); }
    PictureInFlight& last() { return flights_.back(); }
    // Takes the picture that was started first.
    PictureInFlight take() {
        PictureInFlight flight = std::move(flights_.front());
        flights_.pop_front();
        return flight;
    }

    // Runs the action. If it throws, no picture is in flight any more.
    template<class Action> void guard(const Action& action) {
        try {
            action();
        } catch (...) {
            flights_.clear();
            throw;
        }
    }

    // A buffer of so many bytes for a picture's pixels; reuses one that was given back, if any.
    gpu::Transfer transfer(std::size_t bytes) {
        if (spare_.empty()) return gpu::Transfer(bytes);
        gpu::Transfer transfer = std::move(spare_.back());
        spare_.pop_back();
        return transfer;
    }
    void give_back(gpu::Transfer transfer) { spare_.push_back(std::move(transfer)); }

private:
    std::deque<PictureInFlight> flights_;
    std::vector<gpu::Transfer> spare_;
};

} // namespace isomotion::render
