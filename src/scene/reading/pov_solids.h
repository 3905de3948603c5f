// Objects of POV-Ray as a tree: solids by formulas, and what is made of them.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scene/reading/pov_look.h"
#include "scene/reading/pov_moves.h"

namespace isomotion::scene {

struct PovBall { // in POV-Ray's axes
    glm::dvec3 centre{0};
    double radius = 0;
};

// A sphere or a box that bounds an object, in the object's coordinates.
struct PovBounds {
    std::size_t line = 0;
    std::string text;    // the value of surface.bounds
    std::string formula; // below 0 inside
    bool is_hint = false;
    bool is_capped = false; // what they cut gets a wall, where it is a part of another object
    std::optional<PovBall> ball = std::nullopt; // around it, if it does not move
};

struct PovSolid {
    // `clip` is the first part where it lies in all others, open where they cut it. `surfaces` are
    // all that its parts show, also within one another.
    enum class Kind { formula, unite, merge, meet, clip, surfaces };

    Kind kind{};
    std::string word; // of the file: "torus"
    std::size_t line = 0;
    std::string formula; // below 0 inside, of our x, y and z, before `moves`
    std::vector<std::shared_ptr<const PovSolid>> parts;
    std::vector<PovMove> moves;
    PovLook look;                    // has no colour if that of what it is a part of counts
    std::optional<PovBounds> bounds; // where alone its surface is
    std::optional<PovBounds> shape;  // of a sphere or box, the bounds that it makes
    bool is_inverse = false;
    bool is_closed = false;  // its surface is all around what is inside
    bool is_endless = false; // goes on in all directions of a line or a plane
    int depth = 1;           // of parts in one another
    // What follows from its parts, so that nobody need go through them again.
    std::set<std::string> looks; // as texts, "" for that around; two at most, as more do not matter
    bool is_colored = false;     // something of it can be seen in a colour of its own
    void take_looks();
};

using PovSolids = std::map<std::string, std::shared_ptr<const PovSolid>>;

// Reads objects with all that their braces hold.
class PovSolidReader {
public:
    PovSolidReader(PovValues& values, PovLooks& looks, const PovMoves& moves)
        : values_(&values)
        , looks_(&looks)
        , moves_(&moves) {}

    static bool is_solid(const PovWord& word);
    static std::string known_words();
    PovSolid read(PovCursor& at);
    // The object after "=". One that cannot be read is a mistake only where it is used.
    void declare(const std::string& name, PovCursor& at);
    void forget(const std::string& name);

private:
    void read_shape(PovCursor& at, PovSolid& solid);
    void read_parts(PovCursor& at, PovSolid& solid);
    PovSolid named(PovCursor& at);
    void read_modifiers(PovCursor& at, PovSolid& solid);
    bool read_modifier(PovCursor& at, PovSolid& solid);
    void read_bounds(PovCursor& at, PovSolid& solid);
    void read_isosurface(PovCursor& at, PovSolid& solid);
    void read_polynomial(PovCursor& at, PovSolid& solid);

    PovValues* values_;
    PovLooks* looks_;
    const PovMoves* moves_;
    PovSolids declared_;
    std::map<std::string, std::string> mistakes_; // of declared objects
    int depth_ = 0, count_ = 0;
};

} // namespace isomotion::scene
