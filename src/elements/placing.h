// Finds the cells of a grid that a level set meets.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "elements/quadric.h"

namespace isomotion::elements {

// Cells from first to last on each axis, both included.
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

    // A box around all places of a cell, with a margin for rounding.
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
            cells.first[k] = int(std::clamp(least[k] / cell_[k], 0.0, end));
            cells.last[k] = int(std::clamp(most[k] / cell_[k], 0.0, end));
        }
        return cells;
    }

    // The distance of a level set to the cells of its block, row by row along x. Sets are convex,
    // so the cells of a row that a set meets are contiguous.
    class Meeting {
    public:
        explicit Meeting(const Placing& of)
            : of_(of) {}

        void take(const LevelSet& set, const Block& block) {
            set_ = &set;
            block_ = block;
            if (set.kind != LevelSet::Kind::bounded || set.is_box) return;
            if (set.is_round) {
                for (int k = 0; k < 3; ++k) take_axis(k);
            } else {
                take_diagonal();
            }
        }

        // The first and the last cell of a row of its block that the set meets; none if the last is
        // less. For a box, all cells of the row.
        std::pair<int, int> row(int y, int z) {
            int first = block_.first.x, last = block_.last.x;
            if (set_->kind == LevelSet::Kind::unbounded || set_->is_box) return {first, last};
            double farthest = 1;
            if (set_->is_round) {
                row_ = squares_[1][std::size_t(y - block_.first.y)] +
                       squares_[2][std::size_t(z - block_.first.z)];
            } else {
                farthest = farthest_;
                take_row(y, z);
                // The outermost cells hold everything beyond them.
                if (is_end(1, y) || is_end(2, z)) return {first, last};
            }
            if (row_ > farthest && set_->is_round) return {0, -1};
            const bool keeps_first = !set_->is_round && is_end(0, first);
            const bool keeps_last = !set_->is_round && is_end(0, last);
            while (!keeps_first && first <= last && square(first) > farthest) ++first;
            while (!keeps_last && first <= last && square(last) > farthest) --last;
            return {first, last};
        }

        // The least roots of the form in these cells of the row last passed to row().
        std::span<const double> roots(int first, int last) {
            roots_.assign(std::size_t(last - first + 1), 0);
            if (set_->kind == LevelSet::Kind::unbounded) return roots_;
            for (int x = first; x <= last; ++x) roots_[std::size_t(x - first)] = square(x);
            // The form's root is a norm: no place of a cell is nearer than the cell's middle by
            // more than half of its diagonal.
            const double half_cell = set_->is_round ? 0 : half_cell_;
            for (double& root : roots_)
                root = std::max(std::sqrt(std::max(0.0, root)) - half_cell, 0.0);
            return roots_;
        }

    private:
        // The form at the cell's nearest place for round sets, otherwise at its middle.
        double square(int x) const {
            if (set_->is_round) return row_ + squares_[0][std::size_t(x - block_.first.x)];
            const double off = middle(0, x);
            return row_ + off * (slope_ + set_->form.xx * off);
        }
        double middle(int k, int place) const {
            return of_.low_[k] + (place + 0.5) * of_.cell_[k] - set_->centre[k];
        }
        // The squared distance along one axis, for each of the block's cells.
        void take_axis(int k) {
            std::vector<double>& squares = squares_[std::size_t(k)];
            squares.clear();
            const double half_cell = 0.5 * of_.cell_[k] + of_.slack_[k];
            const double scale = 1 / (set_->half[k] * set_->half[k]);
            for (int place = block_.first[k]; place <= block_.last[k]; ++place) {
                const double off = middle(k, place);
                // Distances from the centre to the cell. The outermost cells hold everything beyond
                // them.
                const double below = place == 0 ? 0 : off - half_cell;
                const double above = place + 1 == of_.across_[k] ? 0 : -off - half_cell;
                const double near = std::max({below, above, 0.0});
                squares.push_back(near * near * scale);
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
        void take_row(int y, int z) {
            const Symmetric& form = set_->form;
            const double v = middle(1, y), w = middle(2, z);
            row_ = v * (form.yy * v + 2 * form.yz * w) + form.zz * w * w;
            slope_ = 2 * (form.xy * v + form.xz * w);
        }
        bool is_end(int k, int place) const { return place == 0 || place + 1 == of_.across_[k]; }

        const Placing& of_;
        const LevelSet* set_ = nullptr;
        Block block_;
        std::array<std::vector<double>, 3> squares_; // for round sets
        double row_ = 0;       // the part of the square that is constant in the row
        double slope_ = 0;     // for other sets, the coefficient of x
        double half_cell_ = 0; // in the form's norm
        double farthest_ = 0;
        std::vector<double> roots_;
    };

private:
    glm::dvec3 low_, cell_;
    glm::ivec3 across_;
    glm::dvec3 slack_;
};

} // namespace isomotion::elements
