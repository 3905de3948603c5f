// Which cells of a grid a level set meets.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "elements/quadric.h"

namespace isomotion::elements {

// Cells from first to last, both included, on each axis.
struct Block {
    glm::ivec3 first{0}, last{-1};

    double cells() const {
        const glm::dvec3 side(last - first + 1);
        return side.x * side.y * side.z;
    }
};

class Placing {
public:
    Placing(const Region& region, const glm::ivec3& across)
        : low_(region.low)
        , cell_((region.high - region.low) / glm::dvec3(across))
        , across_(across)
        // Shaders compute a place's cell in float32.
        , slack_(0x1p-14 * cell_ + 0x1p-21 * (glm::abs(region.low) + glm::abs(region.high))) {}

    const glm::dvec3& cell() const { return cell_; }

    // All places that belong to a cell, and what rounding takes for them.
    std::pair<glm::dvec3, glm::dvec3> box(const glm::ivec3& place) const {
        const glm::dvec3 low = low_ + glm::dvec3(place) * cell_;
        return {low - slack_, low + cell_ + slack_};
    }

    Block block(const LevelSet& set) const {
        Block cells;
        if (set.kind == LevelSet::Kind::empty) return cells;
        if (set.kind == LevelSet::Kind::unbounded) return {glm::ivec3(0), across_ - 1};
        const glm::dvec3 least = set.centre - set.half - slack_ - low_;
        const glm::dvec3 most = set.centre + set.half + slack_ - low_;
        for (int k = 0; k < 3; ++k) {
            // Places outside of the grid belong to its outermost cells.
            const double end = across_[k] - 1;
            cells.first[k] = int(std::clamp(std::floor(least[k] / cell_[k]), 0.0, end));
            cells.last[k] = int(std::clamp(std::floor(most[k] / cell_[k]), 0.0, end));
        }
        return cells;
    }

    // How near a level set comes to the cells of its block.
    class Meeting {
    public:
        explicit Meeting(const Placing& of)
            : of_(of) {}

        void take(const LevelSet& set, const Block& block) {
            set_ = &set;
            first_ = block.first;
            if (set.kind != LevelSet::Kind::bounded) return;
            if (set.is_round) {
                for (int k = 0; k < 3; ++k) take_axis(k, block);
            } else {
                take_diagonal();
            }
        }

        // The least root of the form in the cell; 2 if the set does not meet it.
        double operator()(const glm::ivec3& place) const {
            if (set_->kind == LevelSet::Kind::unbounded) return 0;
            constexpr double none = 2;
            if (set_->is_round) {
                const glm::ivec3 at = place - first_;
                const double square = squares_[0][std::size_t(at.x)] +
                                      squares_[1][std::size_t(at.y)] +
                                      squares_[2][std::size_t(at.z)];
                return square > 1 ? none : std::sqrt(square);
            }
            // The form's root is a norm: no place of the cell is nearer than its middle by more
            // than half of the cell's diagonal.
            const glm::dvec3 off = of_.low_ + (glm::dvec3(place) + 0.5) * of_.cell_ - set_->centre;
            const double square = glm::dot(off, set_->form * off);
            if (square <= farthest_)
                return std::max(std::sqrt(std::max(square, 0.0)) - half_cell_, 0.0);
            // The outermost cells hold all that is beyond them.
            return is_on_border(place) ? 1 : none;
        }

    private:
        // The square of the part along one axis, of each of the block's cells.
        void take_axis(int k, const Block& block) {
            std::vector<double>& squares = squares_[std::size_t(k)];
            squares.clear();
            const double half_cell = 0.5 * of_.cell_[k] + of_.slack_[k];
            for (int place = block.first[k]; place <= block.last[k]; ++place) {
                const double off = of_.low_[k] + (place + 0.5) * of_.cell_[k] - set_->centre[k];
                // From the centre to the cell. The outermost cells hold all that is beyond them.
                const double below = place == 0 ? 0 : off - half_cell;
                const double above = place + 1 == of_.across_[k] ? 0 : -off - half_cell;
                const double near = std::max({below, above, 0.0});
                squares.push_back(near * near / (set_->half[k] * set_->half[k]));
            }
        }
        void take_diagonal() {
            const glm::dvec3 corner = 0.5 * of_.cell_ + of_.slack_;
            half_cell_ = 0;
            for (const glm::dvec3 sign : {glm::dvec3(1, 1, 1), glm::dvec3(1, 1, -1),
                                          glm::dvec3(1, -1, 1), glm::dvec3(-1, 1, 1)}) {
                const glm::dvec3 d = sign * corner;
                half_cell_ = std::max(half_cell_, glm::dot(d, set_->form * d));
            }
            half_cell_ = std::sqrt(half_cell_);
            farthest_ = (1 + half_cell_) * (1 + half_cell_);
        }
        bool is_on_border(const glm::ivec3& place) const {
            return glm::any(glm::equal(place, glm::ivec3(0))) ||
                   glm::any(glm::equal(place, of_.across_ - 1));
        }

        const Placing& of_;
        const LevelSet* set_ = nullptr;
        glm::ivec3 first_{0};
        std::array<std::vector<double>, 3> squares_;
        double half_cell_ = 0; // of others, in the form's norm
        double farthest_ = 0;
    };

private:
    glm::dvec3 low_, cell_;
    glm::ivec3 across_;
    glm::dvec3 slack_;
};

} // namespace isomotion::elements
