// Pictures that were asked for and not taken yet, in order: each with its pixels on their way, or
// drawn already.
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
    std::optional<gpu::Transfer> pixels;   // to come
    std::optional<Picture> picture;        // or itself
    std::chrono::duration<double> begun{}; // the time that asking took
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
    // Takes the one asked for first.
    PictureInFlight take() {
        PictureInFlight flight = std::move(flights_.front());
        flights_.pop_front();
        return flight;
    }

    // Does it; if it throws, no picture is on its way any more.
    template<class Action> void guard(const Action& action) {
        try {
            action();
        } catch (...) {
            flights_.clear();
            throw;
        }
    }

    // A buffer of so many bytes for a picture's pixels, of those given back if there is one.
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
