// Which cells of a grid a level set meets.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

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

    // Whether the set may meet the cell, of those of its block.
    class Meeting {
    public:
        Meeting(const Placing& of, const LevelSet& set)
            : of_(of)
            , set_(set) {
            if (set.kind != LevelSet::Kind::bounded || set.is_round) return;
            const glm::dvec3 corner = 0.5 * of.cell_ + of.slack_;
            for (const glm::dvec3 sign : {glm::dvec3(1, 1, 1), glm::dvec3(1, 1, -1),
                                          glm::dvec3(1, -1, 1), glm::dvec3(-1, 1, 1)}) {
                const glm::dvec3 d = sign * corner;
                half_cell_ = std::max(half_cell_, glm::dot(d, set.form * d));
            }
            half_cell_ = std::sqrt(half_cell_);
        }

        // The least root of the form in the cell; above 1 if the set does not meet the cell.
        double operator()(const glm::ivec3& place) const {
            if (set_.kind == LevelSet::Kind::unbounded) return 0;
            const glm::dvec3 middle = of_.low_ + (glm::dvec3(place) + 0.5) * of_.cell_;
            const glm::dvec3 off = middle - set_.centre;
            double root;
            if (set_.is_round) {
                // The nearest place of the cell.
                const glm::dvec3 near =
                    glm::max(glm::abs(off) - 0.5 * of_.cell_ - of_.slack_, 0.0) / set_.half;
                root = glm::length(near);
            } else {
                // The form's root is a norm: no place of the cell is nearer than its middle by
                // more than half of the cell's diagonal.
                root = std::max(std::sqrt(glm::dot(off, set_.form * off)) - half_cell_, 0.0);
            }
            // The outermost cells hold all that is beyond them.
            return is_on_border(place) ? std::min(root, 1.0) : root;
        }

    private:
        bool is_on_border(const glm::ivec3& place) const {
            return glm::any(glm::equal(place, glm::ivec3(0))) ||
                   glm::any(glm::equal(place, of_.across_ - 1));
        }

        const Placing& of_;
        const LevelSet& set_;
        double half_cell_ = 0; // in the form's norm
    };

private:
    glm::dvec3 low_, cell_;
    glm::ivec3 across_;
    glm::dvec3 slack_;
};

} // namespace isomotion::elements
