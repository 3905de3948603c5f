// The first of what sections leave along a ray: a root of F outside of them, or a cap
// (scene/cut.h). As with roots, every statement holds for all rays of the tube.
//
// A section's surface is crossed in closed form. Rounding makes an edge of it, a piece of the tube
// in which some ray may cross. Between edges the tube is kept or taken away as a whole: in kept
// pieces the finder of roots is asked, and over edges the sign of F.
#pragma once

#include <span>
#include <vector>

#include "scene/cut.h"
#include "scene/scene_at.h"
#include "truth/first_root.h"
#include "truth/tube.h"

namespace isomotion::truth {

// The sections of a scene at a time, as shaders have them.
class Sections {
public:
    explicit Sections(const scene::SceneAt& now);
    bool empty() const { return all_.empty(); }

    struct Piece {
        enum class Kind { kept, taken, edge };
        Kind kind = Kind::kept;
        double low = 0, high = 0;
        int section = -1; // of an edge, one whose surface may be crossed there
    };
    // The tube from `near` to `far`, without gaps.
    std::vector<Piece> pieces(const Tube& tube) const;
    const scene::SectionAt& operator[](int k) const { return all_[std::size_t(k)]; }

private:
    std::vector<scene::SectionAt> all_; // formula coordinates, rounded to float32
};

// As RootFinder::find() has it where nothing is cut.
void find_first(RootFinder& finder, const Sections& sections, std::span<const Tube> tubes,
                std::span<FirstRoot> roots);

} // namespace isomotion::truth
