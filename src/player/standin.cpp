#include "player/views.h"
#include "player/controls.h"
#include "player/marks.h"
#include "player/orbit.h"
#include "player/pacing.h"
#include "image/screen.h"
#include "player/camera_text.h"
#include "player/memory.h"
#include "player/watch.h"
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

std::string camera_text(const scene::CameraAt&, double) { return ""; }
std::vector<Slider> sliders(const std::vector<Span>&, const animation::Values&, const Released&) { return {}; }
std::vector<ArrayControls> array_controls(const scene::Scene&, const animation::Values&, const Released&) { return {}; }
TopologyMarks read_topology_marks(const scene::Scene&) { return {}; }
std::filesystem::path timeline_path(const scene::Scene& s) { return s.file; }
FileWatch::FileWatch(const std::vector<std::filesystem::path>&) {}
void FileWatch::watch(const std::vector<std::filesystem::path>&) {}
std::vector<std::filesystem::path> FileWatch::changed() { return {}; }
std::vector<std::filesystem::path> files_of(const scene::Scene&) { return {}; }
std::vector<std::filesystem::path> shader_files() { return {}; }
Memory::Memory(std::filesystem::path, Warn) {}
SceneMemory Memory::recall(const std::filesystem::path&) const { return {}; }
void Memory::remember(const std::filesystem::path&, const SceneMemory&) const {}
std::vector<std::filesystem::path> Memory::opened() const { return {}; }
void Memory::add_opened(const std::filesystem::path&) const {}
std::filesystem::path state_folder() { return {}; }
Rgb heat(double u) { auto c = std::uint8_t(255*u); return {c,c,std::uint8_t(255-c)}; }
const std::array<VerdictColour, 5>& verdict_colours() { static const std::array<VerdictColour,5> a{}; return a; }
}
