#include "player/views.h"
#include "player/controls.h"
#include "player/marks.h"
#include "player/orbit.h"
#include "player/pacing.h"
#include "image/screen.h"
namespace isomotion::player {
std::string_view name(View view) { for (auto& v : view_names) if (v.view == view) return v.name; return "?"; }
std::vector<synthesis::Channel> channels_of(View) { return {}; }
Raster shaded(const image::Frame& f) { return {f.width, f.height, image::screen_codes(f)}; }
Raster shown(View, const image::Frame& f) { return shaded(f); }
double heat_end(const image::Frame&) { return 1; }
Raster evaluations(const image::Frame& f, double) { return shaded(f); }
Difference difference(const image::Frame& a, const image::Frame&) { Difference d; d.raster = shaded(a); return d; }
scene::Scene apply(scene::Scene s, const Released&) { return s; }
std::vector<Span> spans(const scene::Scene&) { return {}; }
std::vector<Mark> key_marks(const scene::Scene&) { return {}; }
scene::CameraAt orbited(const scene::CameraAt& c, const glm::dvec2&) { return c; }
scene::CameraAt panned(const scene::CameraAt& c, const glm::dvec2&) { return c; }
scene::CameraAt dollied(const scene::CameraAt& c, double, const glm::dvec2&) { return c; }
}
