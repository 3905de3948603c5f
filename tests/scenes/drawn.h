// A picture of a test's scene, and the numbers that statements may name of it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "scene/rays.h"
#include "scene/scene.h"
#include "scenes/placeholders.h"

namespace isomotion::scenes {

// How a picture is drawn.
struct Look {
    std::string gallery;                   // an animation's name; empty: the file's own scene
    Values with;                           // of places in the scene
    std::vector<std::string> set;          // as --set
    std::vector<shader::Channel> channels; // beside those that every picture has
    int frame = 1;                         // 0: the scene's poster
    std::optional<render::MarchPlan> plan;
    render::StageChoice stage = render::StageChoice::fragment;
};

// What one says is drawn once.
std::string key_of(const std::string& scene, const Look& look);

struct Drawn {
    scene::Scene scene;
    scene::SceneAt now;
    render::Picture picture;
};

Drawn draw(gpu::Context& context, const std::string& scene, const std::string& file,
           const Look& look);

// The numbers of a pixel, all of the world:
//   R G B A; Z, x y z, nx ny nz, verdict, found (whether there is a hit), hit (with a gradient),
//   evaluations; surface, cap, velocity velocity_x velocity_y where the picture has them;
//   u v: the picture's coordinates, from -1 to 1, v upwards; column, row, from the top;
//   ox oy oz, dx dy dz: where the pixel's ray begins, before the scene, and its direction;
//   radius: that of the bounds
// and those of the whole picture:
//   hits, finds, misses, nans, limits, passes, total (evaluations), eye, shadow, path, occlusion
//   (evaluations of these rays), undecided (shadow rays), most_shadow, width, height; and whether
//   shaders find elements by_place, have_lists of them, and take_gradient on the way
class PixelNumbers {
public:
    explicit PixelNumbers(const Drawn& drawn); // which must outlive it
    std::vector<std::string> names(const std::string& prefix) const;
    void add(std::size_t pixel, std::vector<double>& to) const;

private:
    const Drawn& drawn_;
    scene::Rays rays_; // of the first surface
    std::vector<std::pair<const char*, const std::vector<float>*>> layers_;
    const std::vector<float>& verdicts_;
};
std::vector<std::string> total_names(const std::string& prefix);
void add_totals(const Drawn& drawn, std::vector<double>& to);

} // namespace isomotion::scenes
