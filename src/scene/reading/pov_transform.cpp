#include "scene/reading/pov_transform.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/reading/toml_lines.h"

namespace isomotion::scene {
namespace {

// The three numbers, if their texts state only these.
std::optional<glm::dvec3> plain(const PovValue& numbers) {
    return std::ranges::all_of(numbers, &PovNumber::is_plain) ? still_vector(numbers)
                                                              : std::nullopt;
}

// Rotations about x, then y, then z, of angles in radians.
glm::dmat3 rotation(const glm::dvec3& angle) {
    const glm::dvec3 c = glm::cos(angle), s = glm::sin(angle);
    const glm::dmat3 x(1, 0, 0, 0, c.x, s.x, 0, -s.x, c.x);
    const glm::dmat3 y(c.y, 0, -s.y, 0, 1, 0, s.y, 0, c.y);
    const glm::dmat3 z(c.z, s.z, 0, -s.z, c.z, 0, 0, 0, 1);
    return z * y * x;
}

glm::dmat3 with_axes_swapped(const glm::dmat3& m) {
    const glm::dmat3 swap(1, 0, 0, 0, 0, 1, 0, 1, 0);
    return swap * m * swap;
}

// The angles, in degrees, of which `rotation` makes the matrix.
glm::dvec3 angles_of(const glm::dmat3& m) {
    const double y = -std::asin(std::clamp(m[0].z, -1.0, 1.0));
    if (std::abs(m[0].z) > 1 - 1e-12)
        return glm::degrees(glm::dvec3(std::atan2(-m[2].y, m[1].y), y, 0));
    return glm::degrees(glm::dvec3(std::atan2(m[1].z, m[2].z), y, std::atan2(m[0].y, m[0].x)));
}

std::string quoted_list(const PovValue& numbers) {
    return fmt::format("[{}, {}, {}]", toml_text(numbers[0].text), toml_text(numbers[1].text),
                       toml_text(numbers[2].text));
}

} // namespace

bool PovTransform::translate(const PovValue& by) {
    const PovValue swapped{by[0], by[2], by[1]};
    const auto still = plain(swapped);
    if (still && !last_) {
        still_ += *still;
        return true;
    }
    if (!last_) {
        last_ = swapped;
        return true;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        (*last_)[k] = {fmt::format("({}) + ({})", (*last_)[k].text, swapped[k].text),
                       PovNumber::Strength::sum, std::nullopt};
    }
    return true;
}

bool PovTransform::rotate(const PovValue& angles) {
    if (last_ || turn_) return false;
    if (const auto still = plain(angles)) {
        const glm::dmat3 turn = with_axes_swapped(rotation(glm::radians(*still)));
        rotation_ = turn * rotation_;
        still_ = turn * still_;
        return true;
    }
    // One that moves goes first, about one axis.
    const auto is_zero = [](const PovNumber& n) { return n.value == 0.0; };
    if (std::ranges::count_if(angles, is_zero) != 2 || rotation_ != glm::dmat3(1) ||
        still_ != glm::dvec3(0))
        return false;
    // A rotation about a swapped axis goes the other way round.
    turn_ = PovValue{angles[0], angles[2], angles[1]};
    for (PovNumber& angle : *turn_) {
        if (is_zero(angle)) continue;
        angle = {fmt::format("-({})", angle.text), PovNumber::Strength::sum, std::nullopt};
    }
    return true;
}

bool PovTransform::scale(const PovValue& by) {
    const auto still = plain(by); // parameters stay in the formula
    if (last_ || turn_ || !still || still->x != still->y || still->x != still->z || !(still->x > 0))
        return false;
    scale_ *= still->x;
    still_ *= still->x;
    return true;
}

bool PovTransform::add(const PovMove& move) {
    is_there_ = true;
    switch (move.kind) {
    case PovMove::Kind::translate:
        return translate(move.by);
    case PovMove::Kind::rotate:
        return rotate(move.by);
    case PovMove::Kind::scale:
        return scale(move.by);
    case PovMove::Kind::matrix:
        return false;
    }
    return false;
}

std::optional<std::string> PovTransform::toml() const {
    if (!is_there_) return std::nullopt;
    std::string translate = toml_text(still_);
    if (last_) {
        PovValue all = *last_;
        for (int k = 0; k < 3; ++k) {
            if (still_[k] == 0) continue;
            all[std::size_t(k)].text =
                fmt::format("{} + ({})", still_[k], all[std::size_t(k)].text);
        }
        translate = quoted_list(all);
    }
    const std::string rotate = turn_ ? quoted_list(*turn_) : toml_text(angles_of(rotation_));
    return fmt::format("{{ translate = {}, rotate = {}, scale = {} }}", translate, rotate, scale_);
}

} // namespace isomotion::scene
