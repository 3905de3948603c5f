// Finds the first surface along a ray that sections leave: a root of F outside of them, or a cap
// (scene/cut.h). As with roots, every statement holds for all rays of the tube.
//
// Crossings of a section's surface have a closed form. By rounding a crossing becomes an edge, a
// piece of the tube in which some ray may cross. Between edges the whole tube is kept or taken
// away. The root finder searches kept pieces; on edges the sign of F decides.
#pragma once

#include <span>
#include <vector>

#include "roots/first_root.h"
#include "roots/tube.h"
#include "scene/cut.h"
#include "scene/scene_at.h"

namespace isomotion::roots {

// The sections of a scene at a time, in the shaders' precision.
class Sections {
public:
    explicit Sections(const scene::OneSurfaceAt& now);
    bool empty() const { return all_.empty(); }

    struct Piece {
        enum class Kind { kept, taken, edge };
        Kind kind = Kind::kept;
        double low = 0, high = 0;
        int section = -1; // for an edge: a section whose surface may be crossed there
    };
    // The pieces of the tube from `near` to `far`, without gaps.
    std::vector<Piece> pieces(const Tube& tube) const;
    const scene::SectionAt& operator[](int k) const { return all_[std::size_t(k)]; }

private:
    std::vector<scene::SectionAt> all_; // formula coordinates, rounded to float32
};

// Does what RootFinder::find() does for rays without sections.
void find_first(RootFinder& finder, const Sections& sections, std::span<const Tube> tubes,
                std::span<FirstRoot> roots);

} // namespace isomotion::roots
