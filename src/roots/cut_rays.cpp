#include "roots/cut_rays.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "roots/outward.h"

namespace isomotion::roots {
namespace {

using Piece = Sections::Piece;
using Kind = Piece::Kind;

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// How far off a section's surface a ray of the tube may be when it takes itself to be on it: as far
// as the ray is off, in three coordinates, and what float32 makes of the section's own value.
double margin_of(const scene::SectionAt& section, const Tube& tube) {
    const double size = largest(tube.anchor) + largest(section.where) + std::abs(section.reach) +
                        std::max(std::abs(tube.near), std::abs(tube.far));
    return 4 * tube.radius + 64 * scene::RayRounding::unit * size;
}

// Where the middle of the tube is nearer to the ball's centre than `radius`.
struct Span {
    double low = 1, high = 0;
    bool empty() const { return !(low <= high); }
};
Span within(const glm::dvec3& centre, double radius, const Tube& tube) {
    if (!(radius > 0)) return {};
    const glm::dvec3 from = tube.anchor - centre;
    const double middle = -glm::dot(from, tube.direction);
    const double foot = glm::length(from + middle * tube.direction);
    if (!(foot < radius)) return {};
    const double half = std::sqrt((radius - foot) * (radius + foot));
    return {middle - half, middle + half};
}

// Certainly taken away, and possibly: where a section's value is above its margin, and above minus
// that.
struct Taken {
    Span surely, maybe;
};

Taken taken_by(const scene::SectionAt& section, const Tube& tube) {
    const double margin = margin_of(section, tube);
    if (section.is_ball)
        return {within(section.where, section.reach - margin, tube),
                within(section.where, section.reach + margin, tube)};
    const double height = section.value(tube.anchor);
    const double slope = glm::dot(section.where, tube.direction);
    const auto beyond = [&](double level) -> Span {
        if (slope == 0) return height > level ? Span{-HUGE_VAL, HUGE_VAL} : Span{};
        const double at = (level - height) / slope;
        return slope > 0 ? Span{at, HUGE_VAL} : Span{-HUGE_VAL, at};
    };
    return {beyond(margin), beyond(-margin)};
}

// One ray on its way through its pieces.
struct Way {
    const Tube* tube = nullptr;
    FirstRoot* root = nullptr;
    std::vector<Piece> pieces;
    std::size_t next = 0;
    bool is_done = false;

    const Piece& piece() const { return pieces[next]; }

    // A ray that surely meets nothing but what it may touch.
    void go_on() {
        ++next;
        is_done = next == pieces.size();
    }

    void touch(double from, double to) {
        if (root->answer != Answer::touching) {
            root->answer = Answer::touching;
            root->touch_low = below(from);
        }
        root->touch_high = above(to);
    }

    void end(float low, float high) {
        if (root->answer == Answer::touching) {
            root->after_is_hit = true;
        } else {
            root->answer = Answer::hit;
        }
        root->low = low;
        root->high = high;
        is_done = true;
    }

    // Takes the first root in a piece that is left.
    void take(const FirstRoot& found) {
        switch (found.answer) {
        case Answer::miss:
            go_on();
            return;
        case Answer::hit:
            end(found.low, found.high);
            return;
        case Answer::touching:
            touch(double(found.touch_low), double(found.touch_high));
            if (found.after_is_hit) {
                end(found.low, found.high);
            } else {
                go_on();
            }
            return;
        case Answer::undecided:
            const float known = root->answer == Answer::touching ? root->touch_low : found.low;
            *root = {};
            root->answer = Answer::undecided;
            root->low = known;
            is_done = true;
            return;
        }
    }

    // Takes the sign of F over an edge.
    void take(int sign, const Sections& sections) {
        const Piece& edge = piece();
        if (sign > 0) {
            go_on();
            return;
        }
        // Whatever ray it is, kept on one side of the edge and taken away on the other: its first
        // place on a section within F < 0 is in the edge.
        const bool crosses = next > 0 && next + 1 < pieces.size() &&
                             pieces[next - 1].kind != pieces[next + 1].kind &&
                             pieces[next - 1].kind != Kind::edge &&
                             pieces[next + 1].kind != Kind::edge;
        const bool is_inside = edge.low >= tube->near_inside && edge.high <= tube->far_inside;
        if (sign == 0 || !crosses || !is_inside) {
            touch(edge.low, edge.high);
            go_on();
            return;
        }
        end(below(edge.low), above(edge.high));
        if (root->answer != Answer::hit) return;
        root->cap = edge.section;
        const glm::dvec3 normal = sections[edge.section].gradient(
            tube->anchor + 0.5 * (edge.low + edge.high) * tube->direction);
        root->gradient = {float(normal.x), float(normal.y), float(normal.z)};
    }
};

Tube part_of(const Tube& tube, const Piece& piece) {
    Tube part = tube;
    part.near = piece.low;
    part.far = piece.high;
    part.near_inside = std::max(piece.low, std::min(tube.near_inside, piece.high));
    part.far_inside = std::min(piece.high, std::max(tube.far_inside, piece.low));
    return part;
}

} // namespace

Sections::Sections(const scene::OneSurfaceAt& now) {
    for (const scene::SectionAt& section : now.scene.sections) {
        scene::SectionAt local = in_formula_coordinates(section, now.surface.placement);
        local.where = glm::dvec3(glm::vec3(local.where));
        local.reach = double(float(local.reach));
        all_.push_back(local);
    }
}

std::vector<Piece> Sections::pieces(const Tube& tube) const {
    std::vector<Taken> taken;
    std::vector<double> ends{tube.near, tube.far};
    for (const scene::SectionAt& section : all_) {
        taken.push_back(taken_by(section, tube));
        for (const Span& span : {taken.back().surely, taken.back().maybe}) {
            if (span.empty()) continue;
            for (const double end : {span.low, span.high}) {
                if (end > tube.near && end < tube.far) ends.push_back(end);
            }
        }
    }
    std::ranges::sort(ends);
    std::vector<Piece> pieces;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        Piece piece{Kind::kept, ends[k], ends[k + 1], -1};
        if (!(piece.low < piece.high)) continue;
        const double middle = 0.5 * (piece.low + piece.high);
        const auto holds = [&](const Span& span) {
            return span.low <= middle && middle <= span.high;
        };
        for (std::size_t s = 0; s < taken.size(); ++s) {
            if (holds(taken[s].surely)) {
                piece.kind = Kind::taken;
                break;
            }
            if (!holds(taken[s].maybe)) continue;
            piece.kind = Kind::edge;
            piece.section = int(s);
        }
        if (!pieces.empty() && pieces.back().kind == piece.kind) {
            pieces.back().high = piece.high;
        } else {
            pieces.push_back(piece);
        }
    }
    return pieces;
}

void find_first(RootFinder& finder, const Sections& sections, std::span<const Tube> tubes,
                std::span<FirstRoot> roots) {
    if (sections.empty()) {
        finder.find(tubes, roots);
        return;
    }
    std::vector<Way> ways;
    for (std::size_t k = 0; k < tubes.size(); ++k) {
        roots[k] = {};
        if (!tubes[k].holds) {
            roots[k].answer = Answer::undecided;
            roots[k].low = -HUGE_VALF;
            continue;
        }
        if (!(tubes[k].near <= tubes[k].far)) continue; // passes the bounds by
        Way way{&tubes[k], &roots[k], sections.pieces(tubes[k])};
        if (!way.pieces.empty()) ways.push_back(std::move(way));
    }
    while (!ways.empty()) {
        std::vector<Way*> kept, edges;
        std::vector<Tube> kept_parts, edge_parts;
        for (Way& way : ways) {
            while (!way.is_done && way.piece().kind == Kind::taken) way.go_on();
            if (way.is_done) continue;
            const bool is_edge = way.piece().kind == Kind::edge;
            (is_edge ? edges : kept).push_back(&way);
            (is_edge ? edge_parts : kept_parts).push_back(part_of(*way.tube, way.piece()));
        }
        std::vector<FirstRoot> found(kept_parts.size());
        finder.find(kept_parts, found);
        for (std::size_t k = 0; k < kept.size(); ++k) kept[k]->take(found[k]);
        const std::vector<int> signs = finder.signs(edge_parts);
        for (std::size_t k = 0; k < edges.size(); ++k) edges[k]->take(signs[k], sections);
        std::erase_if(ways, [](const Way& way) { return way.is_done; });
    }
}

} // namespace isomotion::roots
