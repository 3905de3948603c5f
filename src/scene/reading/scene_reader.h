// Reads a document of one surface, or one listed surface with what all share, into a scene: what
// the file says, then its expressions and the values of the first frame, then what is measured.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "base/confines.h"
#include "scene/reading/isolation.h"
#include "scene/reading/material.h"
#include "scene/reading/surface.h"
#include "scene/scene.h"
#include "scene/scene_at.h"

namespace isomotion::scene {

// One of the [[surfaces]] of a document.
struct ListedSurface {
    toml::table& table;
    std::string name; // or its number
    // Parameters of all surfaces; those that this one uses are taken out.
    std::set<std::string>& for_others;
};

// The title of a document that is read from this file.
std::string read_title(Section& document, const std::filesystem::path& file);

class SceneReader {
public:
    // `within`: where files may lie that the scene names.
    SceneReader(toml::table& root, const base::Confines& within,
                std::optional<ListedSurface> listed = std::nullopt);

    // Throws SceneError, Mistakes where they have places. Bounds that are found are put into the
    // document, and so are a look's settings if the surface is the only one.
    Scene read(const std::filesystem::path& file);

private:
    Surface& surface() { return scene_.surfaces.front(); }
    void read_look();
    Section document();
    Section surface_section(Section& document);
    Section sections_of_surface(Section& document);
    void read_document();
    void compile();
    void animate();
    void evaluate();
    void find_bounds();
    void make_field_again();
    bool stays_far_beside(const glm::dvec3& point) const;
    void recentre();
    void measure();

    toml::table& root_;
    const base::Confines& within_;
    std::optional<ListedSurface> listed_;
    toml::table look_; // its settings that the document leaves to it
    MistakeList mistakes_;
    TrackTable tracks_;
    Scene scene_;
    std::uint64_t seed_ = 0;
    std::unique_ptr<SurfaceParts> parts_;
    MaterialParts material_;
    GivenThresholds given_;       // by the scene or the catalogue
    bool misses_surface_ = false; // another formula stands in for its own
    bool may_evaluate_ = false;
    SceneAt first_;
};

} // namespace isomotion::scene
