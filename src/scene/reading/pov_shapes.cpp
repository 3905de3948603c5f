#include "scene/reading/pov_shapes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/reading/toml_lines.h"

namespace isomotion::scene {
namespace {

using Strength = PovNumber::Strength;

// "x - 3" in parentheses, or the letter alone.
std::string from(const char* letter, const PovNumber& origin) {
    const PovNumber name{letter, Strength::atom, std::nullopt};
    const auto plain = origin.plain();
    const PovNumber there =
        plain && *plain < 0 ? joined(name, '+', PovNumber::of(-*plain)) : joined(name, '-', origin);
    return there.strength == Strength::atom ? there.text : fmt::format("({})", there.text);
}

std::string in_sum(const PovNumber& n) {
    return n.strength == Strength::sum ? fmt::format("({})", n.text) : n.text;
}

PovNumber half(const PovNumber& n) { return joined(n, '/', PovNumber::of(2)); }

std::string sphere(const PovValue& centre, const PovNumber& radius) {
    return fmt::format("{}^2 + {}^2 + {}^2 - {}", from("x", centre[0]), from("y", centre[2]),
                       from("z", centre[1]), joined(radius, '^', PovNumber::of(2)).text);
}

std::string box(const PovValue& low, const PovValue& high) {
    static constexpr const char* letters[] = {"x", "z", "y"};
    std::array<std::string, 3> sides;
    for (std::size_t k = 0; k < 3; ++k) {
        const PovNumber middle = half(joined(low[k], '+', high[k]));
        PovNumber reach = half(joined(high[k], '-', low[k]));
        if (const auto plain = reach.plain())
            reach = PovNumber::of(std::abs(*plain));
        else
            reach = {fmt::format("abs({})", reach.text), Strength::atom, std::nullopt};
        sides[k] = fmt::format("abs({}) - {}", from(letters[k], middle), reach.text);
    }
    return fmt::format("max({}, {}, {})", sides[0], sides[2], sides[1]);
}

// Coordinates whose third one runs from one end to the other: rows of a rotation.
struct Axis {
    std::array<std::array<double, 3>, 3> rows{};
    double length = 0;
};

Axis axis_of(const PovCursor& at, std::string_view word, const PovValue& begin,
             const PovValue& end) {
    const auto a = still_vector(begin), b = still_vector(end);
    if (!a || !b)
        at.fail(word, "must have ends that do not move; move the whole by translate or rotate");
    const double length = glm::length(*b - *a);
    if (!(length > 0)) at.fail(word, "must have two ends that differ");
    const glm::dvec3 along = (*b - *a) / length;
    // Across: the axis that is least along, so that axes stay axes.
    int least = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(along[k]) < std::abs(along[least])) least = k;
    glm::dvec3 across(0);
    across[least] = 1;
    const glm::dvec3 first = glm::normalize(across - along * glm::dot(across, along));
    const glm::dvec3 second = glm::cross(along, first);
    Axis axis;
    axis.length = length;
    // The third of our coordinates is POV-Ray's second.
    const glm::dvec3 rows[] = {first, along, second};
    for (std::size_t k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) axis.rows[k][std::size_t(j)] = rows[k][j];
    return axis;
}

// Of a formula whose z axis runs from `begin`.
std::string along(const Axis& axis, const PovValue& begin, const std::string& formula) {
    return at_pov_place(formula, PovPlace().turned(axis.rows, begin));
}

// From the radius at the beginning to that at the end; without caps nothing is beyond them.
std::string cone(const Axis& axis, const PovNumber& first, const PovNumber& last, bool is_open) {
    const PovNumber grows = joined(joined(last, '-', first), '/', PovNumber::of(axis.length));
    const PovNumber rise = joined(grows, '*', {"z", Strength::atom, std::nullopt});
    const std::string side = fmt::format("length(x, y) - {}", in_sum(joined(first, '+', rise)));
    const std::string ends = fmt::format("abs(z - {0}) - {0}", axis.length / 2);
    return is_open ? fmt::format("if({} < 0, {}, 1)", ends, side)
                   : fmt::format("max({}, {})", side, ends);
}

void read_cone(PovCursor& at, PovValues& values, PovSolid& solid, bool is_cylinder) {
    const PovValue begin = values.vector(at, solid.word);
    at.take_if(",");
    const PovNumber first = is_cylinder ? PovNumber::of(0) : values.number(at, solid.word);
    at.take_if(",");
    const PovValue end = values.vector(at, solid.word);
    at.take_if(",");
    const PovNumber last = values.number(at, solid.word);
    const Axis axis = axis_of(at, solid.word, begin, end);
    const bool is_open = at.take_if("open");
    solid.formula = along(axis, begin, cone(axis, is_cylinder ? last : first, last, is_open));
    solid.is_closed = !is_open;
}

void read_plane(PovCursor& at, PovValues& values, PovSolid& solid) {
    const PovValue normal = values.vector(at, "plane");
    at.take_if(",");
    const PovNumber distance = values.number(at, "plane");
    const auto still = still_vector(normal);
    if (!still) at.fail("plane", "must have a normal that does not move; rotate the whole");
    const double length = glm::length(*still);
    if (!(length > 0)) at.fail("plane", "must have a normal that is no vector of zeros");
    // A row of a rotation, or nearly: only the distance along the normal matters.
    const glm::dvec3 n = *still / length;
    const auto row =
        PovPlace().turned({{{n.x, n.y, n.z}, {0, 1, 0}, {0, 0, 1}}}, PovValue(3, PovNumber::of(0)));
    const PovNumber sum{row.texts()[0], Strength::sum, std::nullopt};
    solid.formula = joined(sum, '-', distance).text;
}

// (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1, as a norm: finite for all exponents.
void read_superellipsoid(PovCursor& at, PovValues& values, PovSolid& solid) {
    const PovValue powers = values.value(at, solid.word);
    const bool is_right = powers.size() == 2 && powers[0].value && powers[1].value &&
                          *powers[0].value > 0 && *powers[1].value > 0;
    if (!is_right) at.fail(solid.word, "needs two numbers above 0 that do not move: <0.5, 0.5>");
    const double e = *powers[0].value, n = *powers[1].value;
    solid.formula = fmt::format("((abs(x)^{0} + abs(z)^{0})^{1} + abs(y)^{2})^{3} - 1", 2 / e,
                                e / n, 2 / n, n / 2);
}

// 1 at the middle of a component, 0 from `radius` on: what the square of a component sums up.
std::string nearness(const std::string& squares, const PovNumber& radius) {
    return fmt::format("max(1 - ({})/{}, 0)", squares,
                       in_sum(joined(radius, '^', PovNumber::of(2))));
}

std::string component(PovCursor& at, PovValues& values, const PovMoves& declared) {
    const bool is_cylinder = at.take().is("cylinder");
    at.expect("{", "blob");
    const PovValue begin = values.vector(at, "blob");
    at.take_if(",");
    PovValue end;
    if (is_cylinder) {
        end = values.vector(at, "blob");
        at.take_if(",");
    }
    const PovNumber radius = values.number(at, "blob");
    at.take_if(",");
    at.take_if("strength");
    const PovNumber strength = values.number(at, "blob");
    std::string near;
    if (is_cylinder) {
        const Axis axis = axis_of(at, "blob", begin, end);
        near =
            along(axis, begin,
                  nearness(fmt::format("x^2 + y^2 + max(abs(z - {0}) - {0}, 0)^2", axis.length / 2),
                           radius));
    } else {
        near = nearness(fmt::format("{}^2 + {}^2 + {}^2", from("x", begin[0]), from("y", begin[2]),
                                    from("z", begin[1])),
                        radius);
    }
    std::vector<PovMove> moves;
    while (!at.take_if("}")) {
        if (at.at_end()) at.fail("blob", "its braces do not close");
        if (at.now().is("texture") || at.now().is("pigment") || at.now().is("finish")) {
            at.fail("blob", "is read with one look: put it behind the components");
        } else if (!read_pov_move(at, values, declared, moves)) {
            at.fail("blob", fmt::format("'{}' is not read in a component", at.now().text));
        }
    }
    const PovPlace place = PovPlace().before(moves);
    if (place.is_long()) at.fail("blob", "is too long a formula");
    return fmt::format("{}*{}^2", in_sum(strength), at_pov_place(near, place));
}

} // namespace

std::string pov_value_text(const PovNumber& n) { return n.is_plain() ? n.text : toml_text(n.text); }

std::string pov_vector_text(const PovValue& v) {
    return fmt::format("[{}, {}, {}]", pov_value_text(v[0]), pov_value_text(v[1]),
                       pov_value_text(v[2]));
}

std::string pov_sphere_bounds(const PovValue& centre, const PovNumber& radius) {
    return fmt::format("{{ sphere = {}, centre = {} }}", pov_value_text(radius),
                       pov_vector_text({centre[0], centre[2], centre[1]}));
}

std::string pov_ball_bounds(const PovBall& ball) {
    return fmt::format("{{ sphere = {}, centre = [{}, {}, {}] }}", ball.radius, ball.centre.x,
                       ball.centre.z, ball.centre.y);
}

std::string pov_box_bounds(PovValue low, PovValue high) {
    for (std::size_t k = 0; k < 3; ++k) {
        const auto &first = low[k].value, &second = high[k].value;
        if (first && second && *first > *second) std::swap(low[k], high[k]);
    }
    return fmt::format("{{ box = [{}, {}] }}", pov_vector_text({low[0], low[2], low[1]}),
                       pov_vector_text({high[0], high[2], high[1]}));
}

std::string read_pov_blob(PovCursor& at, PovValues& values, const PovMoves& moves) {
    PovNumber threshold = PovNumber::of(1);
    std::string sum;
    for (bool is_more = true; is_more;) {
        if (at.take_if("threshold")) {
            threshold = values.number(at, "threshold");
        } else if (at.now().is("sphere") || at.now().is("cylinder")) {
            sum += " - " + component(at, values, moves);
            if (sum.size() > longest_pov_text) at.fail("blob", "is too long a formula");
        } else {
            is_more = false;
        }
        at.take_if(",");
    }
    if (sum.empty()) at.fail("blob", "needs a component: sphere { <0, 0, 0>, 1, 1 }");
    return in_sum(threshold) + sum;
}

bool read_pov_shape(PovCursor& at, PovValues& values, PovSolid& solid) {
    const std::string& word = solid.word;
    solid.is_closed = true;
    if (word == "sphere") {
        const PovValue centre = values.vector(at, word);
        at.take_if(",");
        const PovNumber radius = values.number(at, word);
        solid.formula = sphere(centre, radius);
        solid.shape = PovBounds{solid.line, pov_sphere_bounds(centre, radius), solid.formula};
        if (const auto still = still_vector(centre); still && radius.value)
            solid.shape->ball = PovBall{*still, *radius.value};
    } else if (word == "box") {
        const PovValue low = values.vector(at, word);
        at.take_if(",");
        const PovValue high = values.vector(at, word);
        solid.formula = box(low, high);
        solid.shape = PovBounds{solid.line, pov_box_bounds(low, high), solid.formula};
        const auto a = still_vector(low), b = still_vector(high);
        if (a && b) solid.shape->ball = PovBall{(*a + *b) / 2.0, glm::length(*b - *a) / 2};
    } else if (word == "cylinder" || word == "cone") {
        read_cone(at, values, solid, word == "cylinder");
    } else if (word == "torus") {
        const PovNumber around = values.number(at, word);
        at.take_if(",");
        const PovNumber tube = values.number(at, word);
        solid.formula =
            fmt::format("length(length(x, y) - {}, z) - {}", in_sum(around), in_sum(tube));
    } else if (word == "superellipsoid") {
        read_superellipsoid(at, values, solid);
    } else if (word == "plane") {
        solid.is_closed = false;
        solid.is_endless = true;
        read_plane(at, values, solid);
    } else {
        solid.is_closed = false;
        return false;
    }
    return true;
}

} // namespace isomotion::scene
