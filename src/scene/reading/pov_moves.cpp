#include "scene/reading/pov_moves.h"

#include <cctype>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace isomotion::scene {
namespace {

using Strength = PovNumber::Strength;

constexpr std::size_t longest_row = 20'000;
constexpr std::size_t most_moves = 100; // of one object

// A right angle's cosine is 0, not 6e-17: axes stay axes.
double cosine(double degrees) {
    const double quarter = std::remainder(degrees, 360) / 90;
    if (quarter == std::round(quarter)) return quarter == 0 ? 1 : std::abs(quarter) == 2 ? -1 : 0;
    return std::cos(degrees * std::numbers::pi / 180);
}

PovNumber cosine(const PovNumber& degrees) {
    if (const auto plain = degrees.plain()) return PovNumber::of(cosine(*plain));
    return {fmt::format("cos(({})*pi/180)", degrees.text), Strength::atom, std::nullopt};
}

PovNumber sine(const PovNumber& degrees) {
    if (const auto plain = degrees.plain()) return PovNumber::of(cosine(*plain - 90));
    return {fmt::format("sin(({})*pi/180)", degrees.text), Strength::atom, std::nullopt};
}

PovNumber negative(const PovNumber& n) { return joined(n, '*', PovNumber::of(-1)); }

// a*x + b*y
template<typename Row>
Row combined(const PovNumber& a, const Row& x, const PovNumber& b, const Row& y) {
    Row all;
    for (std::size_t k = 0; k < all.size(); ++k)
        all[k] = joined(joined(a, '*', x[k]), '+', joined(b, '*', y[k]));
    return all;
}

std::string term(const PovNumber& factor, const char* letter) {
    if (factor.plain() == 1.0) return letter;
    const auto plain = factor.plain();
    if (plain && *plain < 0) return "-" + term(PovNumber::of(-*plain), letter);
    return joined(factor, '*', {letter, Strength::atom, std::nullopt}).text;
}

void add(std::string& sum, const std::string& what) {
    if (sum.empty())
        sum = what;
    else if (what[0] == '-')
        sum += " - " + what.substr(1);
    else
        sum += " + " + what;
}

void expect_regular(const PovValue& by, const PovCursor& at) {
    std::array<double, 12> m{};
    for (std::size_t k = 0; k < m.size(); ++k) {
        const std::optional<double>& number = by[k].value;
        if (!number) at.fail("matrix", "must have numbers that do not move");
        m[k] = *number;
    }
    const double determinant = m[0] * (m[4] * m[8] - m[5] * m[7]) -
                               m[1] * (m[3] * m[8] - m[5] * m[6]) +
                               m[2] * (m[3] * m[7] - m[4] * m[6]);
    double size = 1; // of what is not flat at all
    for (std::size_t row = 0; row < 9; row += 3) size *= std::hypot(m[row], m[row + 1], m[row + 2]);
    if (!(std::abs(determinant) > 1e-12 * size)) at.fail("matrix", "makes the object flat");
}

} // namespace

bool read_pov_move(PovCursor& at, PovValues& values, const PovMoves& declared,
                   std::vector<PovMove>& moves) {
    const std::string word = at.now().text;
    const auto expect_room = [&](std::size_t more) {
        if (moves.size() + more > most_moves)
            at.fail(word, fmt::format("more than {} transformations of one object", most_moves));
    };
    if (word == "transform") {
        at.take();
        const bool is_group = at.take_if("{");
        do {
            const auto known = declared.find(at.now().text);
            if (known != declared.end()) {
                expect_room(known->second.size());
                moves.insert(moves.end(), known->second.begin(), known->second.end());
                at.take();
            } else if (at.now().is("transform") || !read_pov_move(at, values, declared, moves)) {
                at.fail("transform", fmt::format("'{}' is not read here; read are translate, "
                                                 "rotate, scale, matrix and declared transforms",
                                                 at.now().text));
            }
        } while (is_group && !at.now().is("}"));
        if (is_group) at.expect("}", "transform");
        return true;
    }
    if (word == "matrix") {
        at.take();
        expect_room(1);
        PovMove move{PovMove::Kind::matrix, values.value(at, word)};
        if (move.by.size() != 12) at.fail(word, "needs 12 numbers: <1,0,0, 0,1,0, 0,0,1, 0,0,0>");
        expect_regular(move.by, at);
        moves.push_back(move);
        return true;
    }
    if (word != "translate" && word != "rotate" && word != "scale") return false;
    expect_room(1);
    at.take();
    const std::size_t place = at.place();
    PovMove move{word == "translate" ? PovMove::Kind::translate
                 : word == "rotate"  ? PovMove::Kind::rotate
                                     : PovMove::Kind::scale,
                 values.vector(at, word)};
    if (move.kind == PovMove::Kind::scale) {
        for (PovNumber& factor : move.by) {
            if (factor.value != 0.0) continue;
            at.go_to(place - 1);
            at.fail(word, "must not be 0 along an axis: write 1 where the size stays");
        }
    }
    moves.push_back(move);
    return true;
}

PovPlace::PovPlace() {
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t j = 0; j < 4; ++j) rows_[k][j] = PovNumber::of(j == k ? 1 : 0);
}

void PovPlace::undo(const PovMove& move) {
    own_ = false;
    if (move.kind == PovMove::Kind::translate) {
        for (std::size_t k = 0; k < 3; ++k) rows_[k][3] = joined(rows_[k][3], '-', move.by[k]);
    } else if (move.kind == PovMove::Kind::scale) {
        for (std::size_t k = 0; k < 3; ++k)
            for (PovNumber& n : rows_[k])
                if (n.plain() != 0.0) n = joined(n, '/', move.by[k]);
    } else if (move.kind == PovMove::Kind::rotate) {
        // About x, y and z in turn; backwards.
        for (std::size_t axis = 3; axis-- > 0;) {
            const PovNumber& angle = move.by[axis];
            if (angle.plain() == 0.0) continue;
            Row &first = rows_[(axis + 1) % 3], &second = rows_[(axis + 2) % 3];
            const PovNumber c = cosine(angle), s = sine(angle);
            const Row turned = combined(c, first, s, second);
            second = combined(negative(s), first, c, second);
            first = turned;
        }
    } else {
        glm::dmat3 m;
        for (int row = 0; row < 3; ++row) // POV-Ray's rows are images of x, y and z
            for (int k = 0; k < 3; ++k) m[row][k] = *move.by[std::size_t(3 * row + k)].value;
        const glm::dmat3 back = glm::inverse(m);
        for (std::size_t k = 0; k < 3; ++k) rows_[k][3] = joined(rows_[k][3], '-', move.by[9 + k]);
        const std::array<Row, 3> old = rows_;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto part = [&](int j) { return PovNumber::of(back[j][int(k)]); };
            rows_[k] = combined(PovNumber::of(1), combined(part(0), old[0], part(1), old[1]),
                                part(2), old[2]);
        }
    }
}

PovPlace PovPlace::before(const std::vector<PovMove>& moves) const {
    PovPlace place = *this;
    for (std::size_t k = moves.size(); k-- > 0;) {
        place.undo(moves[k]);
        if (place.is_long()) break; // the caller refuses it
    }
    return place;
}

PovPlace PovPlace::turned(const std::array<std::array<double, 3>, 3>& rows,
                          const std::vector<PovNumber>& origin) const {
    PovPlace place = *this;
    place.undo({PovMove::Kind::translate, origin});
    const std::array<Row, 3> old = place.rows_;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto part = [&](std::size_t j) { return PovNumber::of(rows[k][j]); };
        place.rows_[k] =
            combined(PovNumber::of(1), combined(part(0), old[0], part(1), old[1]), part(2), old[2]);
    }
    return place;
}

bool PovPlace::is_long() const {
    for (const Row& row : rows_)
        for (const PovNumber& n : row)
            if (n.text.size() > longest_row) return true;
    return false;
}

std::optional<glm::dvec3> PovPlace::at(const glm::dvec3& point) const {
    glm::dvec3 all(0);
    for (int k = 0; k < 3; ++k) {
        const Row& row = rows_[std::size_t(k)];
        for (const PovNumber& n : row)
            if (!n.value) return std::nullopt;
        all[k] = *row[0].value * point.x + *row[1].value * point.y + *row[2].value * point.z +
                 *row[3].value;
    }
    return all;
}

std::array<std::string, 3> PovPlace::texts() const {
    static constexpr const char* letters[] = {"x", "z", "y"};
    std::array<std::string, 3> all;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 3; ++j)
            if (rows_[k][j].plain() != 0.0) add(all[k], term(rows_[k][j], letters[j]));
        const PovNumber& added = rows_[k][3];
        if (added.plain() != 0.0 || all[k].empty())
            add(all[k], added.is_plain() ? added.text : fmt::format("({})", added.text));
    }
    return all;
}

std::string at_pov_place(const std::string& formula, const PovPlace& place) {
    if (place.is_still()) return formula;
    const auto [x, y, z] = place.texts();
    const auto is_of_name = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
    };
    const auto held = [](const std::string& text) {
        return text.size() == 1 ? text : fmt::format("({})", text);
    };
    std::string all;
    for (std::size_t at = 0; at < formula.size();) {
        std::size_t end = at;
        while (end < formula.size() && is_of_name(formula[end])) ++end;
        const std::string name = formula.substr(at, std::max(end, at + 1) - at);
        const std::string* there = name == "x" ? &x : name == "y" ? &z : name == "z" ? &y : nullptr;
        // "abs(x)" holds what it has already.
        const bool is_held = all.ends_with('(') && formula.substr(at + 1, 1) == ")";
        all += !there ? name : is_held ? *there : held(*there);
        at += name.size();
    }
    return all;
}

} // namespace isomotion::scene
