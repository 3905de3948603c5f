// POV-Ray's translate, rotate, scale, matrix and transform, and where they take points.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/reading/pov_values.h"

namespace isomotion::scene {

// One motion of an object, in POV-Ray's axes.
struct PovMove {
    enum class Kind { translate, rotate, scale, matrix };

    Kind kind{};
    PovValue by; // three numbers; of a matrix twelve
};

// Motions by name: #declare Turn = transform { rotate 30*y }.
using PovMoves = std::map<std::string, std::vector<PovMove>>;

// Appends what one transformation does, if there is one here.
bool read_pov_move(PovCursor& at, PovValues& values, const PovMoves& declared,
                   std::vector<PovMove>& moves);

// Takes a point of the scene to the object's own coordinates. Numbers may name parameters.
class PovPlace {
public:
    PovPlace();

    // Where a part is whose `moves` take it to the place that its own coordinates are here.
    PovPlace before(const std::vector<PovMove>& moves) const;
    // Of a point that this takes where an object is: the object's coordinates by `rows` from there.
    PovPlace turned(const std::array<std::array<double, 3>, 3>& rows,
                    const std::vector<PovNumber>& origin) const;

    bool is_still() const { return own_; } // every point stays where it is
    // The object's x, y and z in POV-Ray's order, as formulas of this program's x, y and z.
    std::array<std::string, 3> texts() const;
    bool is_long() const;
    // Where it takes a point, if nothing moves.
    std::optional<glm::dvec3> at(const glm::dvec3& point) const;

private:
    using Row = std::array<PovNumber, 4>; // of POV-Ray's x, y and z, and what is added

    void undo(const PovMove& move);

    std::array<Row, 3> rows_;
    bool own_ = true;
};

// The formula with other terms in place of its x, y and z, which are POV-Ray's x, z and y.
std::string at_pov_place(const std::string& formula, const PovPlace& place);

} // namespace isomotion::scene
