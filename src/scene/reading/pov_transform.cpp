#include "scene/reading/pov_transform.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/reading/toml_lines.h"

namespace isomotion::scene {
namespace {

// The three numbers, if their texts state only these.
std::optional<glm::dvec3> plain(const std::vector<PovNumber>& numbers) {
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

std::string quoted_list(const std::vector<PovNumber>& numbers) {
    return fmt::format("[{}, {}, {}]", toml_text(numbers[0].text), toml_text(numbers[1].text),
                       toml_text(numbers[2].text));
}

} // namespace

void PovTransform::expect_still(const PovCursor& at, std::string_view what) const {
    if (last_ || turn_)
        at.fail(what, "is not read behind a translate or rotate that moves; put it before");
}

void PovTransform::translate(const std::vector<PovNumber>& by) {
    const std::vector<PovNumber> swapped{by[0], by[2], by[1]};
    const auto still = plain(swapped);
    if (still && !last_) {
        still_ += *still;
        return;
    }
    if (!last_) {
        last_ = swapped;
        return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        (*last_)[k] = {fmt::format("({}) + ({})", (*last_)[k].text, swapped[k].text),
                       PovNumber::Strength::sum, std::nullopt};
    }
}

void PovTransform::rotate(const std::vector<PovNumber>& angles, const PovCursor& at) {
    expect_still(at, "rotate");
    if (const auto still = plain(angles)) {
        const glm::dmat3 turn = with_axes_swapped(rotation(glm::radians(*still)));
        rotation_ = turn * rotation_;
        still_ = turn * still_;
        return;
    }
    const auto is_zero = [](const PovNumber& n) { return n.value == 0.0; };
    if (std::ranges::count_if(angles, is_zero) != 2 || rotation_ != glm::dmat3(1) ||
        still_ != glm::dvec3(0)) {
        at.fail("rotate", "one that moves is read about one axis, as the first transformation");
    }
    // A rotation about a swapped axis goes the other way round.
    turn_ = std::vector<PovNumber>{angles[0], angles[2], angles[1]};
    for (PovNumber& angle : *turn_) {
        if (is_zero(angle)) continue;
        angle = {fmt::format("-({})", angle.text), PovNumber::Strength::sum, std::nullopt};
    }
}

void PovTransform::scale(double by, const PovCursor& at) {
    expect_still(at, "scale");
    if (!(by > 0)) at.fail("scale", "must be above 0");
    scale_ *= by;
    still_ *= by;
}

bool PovTransform::read(PovCursor& at, PovValues& values) {
    const std::size_t place = at.place();
    const std::string word = at.now().text;
    if (word != "translate" && word != "rotate" && word != "scale") {
        if (word == "matrix" || word == "transform")
            at.fail(word, "is not read; write translate, rotate and scale");
        return false;
    }
    at.take();
    const std::vector<PovNumber> by = values.vector(at, word);
    is_there_ = true;
    const std::size_t behind = at.place();
    at.go_to(place); // where mistakes are told
    if (word == "translate") {
        translate(by);
    } else if (word == "rotate") {
        rotate(by, at);
    } else {
        const auto& even = by[0].value;
        if (!even || even != by[1].value || even != by[2].value) {
            at.fail("scale", "must be one number: another along each axis is not read. Write the "
                             "formula in x/2, say, in place of a scale of 2");
        }
        scale(*even, at);
    }
    at.go_to(behind);
    return true;
}

std::optional<std::string> PovTransform::toml() const {
    if (!is_there_) return std::nullopt;
    std::string translate = toml_text(still_);
    if (last_) {
        std::vector<PovNumber> all = *last_;
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
