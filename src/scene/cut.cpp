#include "scene/cut.h"

#include <algorithm>
#include <cmath>

#include "scene/scene_at.h"

namespace isomotion::scene {
namespace {

// What one section takes away of a line.
struct Taken {
    double begin = 0, end = 0;
    int section = 0;
};

std::optional<Taken> taken(const SectionAt& section, int index, const glm::dvec3& anchor,
                           const glm::dvec3& direction) {
    if (section.is_ball) {
        const glm::dvec3 from = anchor - section.where;
        const double middle = -glm::dot(from, direction);
        const double foot = glm::length(from + middle * direction);
        if (!(foot < section.reach)) return std::nullopt;
        const double half = std::sqrt((section.reach - foot) * (section.reach + foot));
        return Taken{middle - half, middle + half, index};
    }
    const double height = section.value(anchor), slope = glm::dot(section.where, direction);
    if (slope == 0) {
        if (height <= 0) return std::nullopt;
        return Taken{-HUGE_VAL, HUGE_VAL, index};
    }
    const double at = -height / slope;
    return slope > 0 ? Taken{at, HUGE_VAL, index} : Taken{-HUGE_VAL, at, index};
}

} // namespace

double SectionAt::value(const glm::dvec3& p) const {
    return is_ball ? reach - glm::distance(where, p) : glm::dot(where, p) - reach;
}

glm::dvec3 SectionAt::gradient(const glm::dvec3& p) const {
    if (!is_ball) return where;
    const double away = glm::distance(where, p);
    return away > 0 ? (where - p) / away : glm::dvec3(1, 0, 0);
}

SectionAt in_formula_coordinates(const SectionAt& section, const PlacementAt& placement) {
    if (section.is_ball)
        return {true, placement.to_local(section.where), section.reach / placement.scale};
    return {false, glm::transpose(placement.rotate) * section.where,
            (section.reach - glm::dot(section.where, placement.translate)) / placement.scale};
}

std::vector<glm::vec4> packed(std::span<const SectionAt> sections) {
    std::vector<glm::vec4> all;
    for (const SectionAt& section : sections)
        all.emplace_back(glm::dvec4(section.where, section.reach));
    return all;
}

std::vector<PartLeft> parts_left(std::span<const SectionAt> sections, const glm::dvec3& anchor,
                                 const glm::dvec3& direction, double near, double far) {
    std::vector<Taken> all;
    for (std::size_t k = 0; k < sections.size(); ++k) {
        if (const auto some = taken(sections[k], int(k), anchor, direction)) all.push_back(*some);
    }
    std::ranges::sort(all, {}, &Taken::begin);
    std::vector<PartLeft> parts;
    PartLeft part{near, far, {}, {}};
    for (const Taken& some : all) {
        if (some.begin >= far) break;
        if (some.begin > part.begin) {
            part.end = some.begin;
            part.end_cut = some.section;
            parts.push_back(part);
        }
        if (some.end >= part.begin) {
            part.begin = some.end;
            part.begin_cut = some.section;
        }
        part.end = far;
        part.end_cut.reset();
    }
    if (part.begin < far) parts.push_back(part);
    return parts;
}

} // namespace isomotion::scene
