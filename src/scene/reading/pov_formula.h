// Composes one formula of an object of POV-Ray and all its parts.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/reading/pov_solids.h"

namespace isomotion::scene {

// Unions are min, intersections max, what is cut away is negative. Clear parts, which POV-Ray does
// not show, cut others open.
class PovFormula {
public:
    // `is_name` tells names that the scene has already.
    PovFormula(const PovCursor& at, std::function<bool(const std::string&)> is_name)
        : at_(&at)
        , is_name_(std::move(is_name)) {}

    // The formula after the object's motions; none if nothing of it can be seen.
    std::optional<std::string> of(const PovSolid& solid);

private:
    struct Piece {
        std::string text;
        bool is_clear = false;
    };

    Piece piece(const PovSolid& solid, const PovPlace& around, bool is_clear);
    Piece united(const PovSolid& solid, const std::vector<Piece>& pieces) const;
    static Piece met(const std::vector<Piece>& pieces);
    std::string moved(const PovSolid& solid, const std::string& formula, const PovPlace& place);

    const PovCursor* at_;
    std::function<bool(const std::string&)> is_name_;
    std::map<std::string, std::string> named_; // names of long formulas that are moved
    std::string definitions_;
    std::size_t pieces_ = 0, moves_ = 0, bytes_ = 0;
};

} // namespace isomotion::scene
