#include <fmt/format.h>

#include "animation/frame_range.h"
#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "api/scene/reach.h"
#include "scene/data_folder.h"
#include "scene/files_read.h"
#include "scene/limits.h"
#include "scene/method.h"
#include "scene/reading/load.h"
#include "scene/surfaces.h"

namespace isomotion {
namespace fs = std::filesystem;
namespace {

using api::with_errors;

Scene loaded(Scene::Parts parts) {
    return with_errors([&] {
        const scene::Reach reach = api::reach_of(parts.reach);
        parts.scene = parts.folder ? scene::load_text(parts.source, *parts.folder / "scene.toml",
                                                      parts.settings, reach)
                                   : scene::load(parts.source, parts.settings, reach);
        for (const auto& change : parts.changes) parts.scene = change(parts.scene);
        return Scene(std::make_shared<const Scene::Parts>(std::move(parts)));
    });
}

// The one that is named, or the only one.
const scene::Surface& surface_of(const scene::Scene& scene, const std::string& name) {
    if (name.empty() && scene.surfaces.size() == 1) return scene.surfaces.front();
    return scene.surfaces[scene::surface_named(scene, name, "surface")];
}

} // namespace

Scene api::changed(const Scene& scene, std::function<scene::Scene(const scene::Scene&)> change) {
    return with_errors([&] {
        Scene::Parts parts = scene.parts();
        parts.scene = change(parts.scene);
        parts.changes.push_back(std::move(change));
        return Scene(std::make_shared<const Scene::Parts>(std::move(parts)));
    });
}

Scene api::with_frames(const Scene& scene, int frames) {
    Scene::Parts parts = scene.parts();
    std::erase_if(parts.settings, [](const std::string& setting) {
        return setting.starts_with("time.seconds=") || setting.starts_with("time.frames=");
    });
    parts.settings.push_back(fmt::format("time.frames={}", frames));
    return loaded(std::move(parts));
}

void set_data_folder(const fs::path& folder) { scene::set_data_folder(folder); }

std::vector<std::string> animations() {
    return with_errors([] { return scene::animation_names(); });
}

std::vector<int> frame_numbers(std::string_view text) {
    return with_errors([&] { return animation::parse_frame_range(text); });
}

std::vector<std::string> methods() {
    std::vector<std::string> names;
    for (const auto& traits : scene::method_traits) names.emplace_back(traits.name);
    return names;
}

static_assert(largest_side == scene::limits::picture_side);

Scene::Scene(std::shared_ptr<const Parts> parts)
    : parts_(std::move(parts)) {}

Scene Scene::load(const std::string& name, const std::vector<std::string>& settings, Reach reach) {
    return loaded({{}, name, std::nullopt, settings, reach, {}});
}

Scene Scene::parse(std::string_view text, const std::vector<std::string>& settings,
                   const fs::path& folder, Reach reach) {
    return loaded({{}, std::string(text), folder, settings, reach, {}});
}

Scene Scene::with(const std::string& key, const std::string& value) const {
    Parts changed{
        {}, parts_->source, parts_->folder, parts_->settings, parts_->reach, parts_->changes};
    changed.settings.push_back(key + "=" + value);
    return loaded(std::move(changed));
}

Scene Scene::with(const std::string& key, double value) const {
    return with(key, fmt::format("{}", value));
}

Scene Scene::alone(const std::string& surface) const {
    return api::changed(*this, [surface](const scene::Scene& scene) {
        return scene::alone({scene, scene::surface_named(scene, surface, "surface")});
    });
}

const std::string& Scene::title() const { return parts_->scene.title; }

std::string Scene::name() const { return parts_->scene.file.stem().string(); }

std::optional<fs::path> Scene::file() const {
    if (parts_->folder || !parts_->scene.formula.empty()) return std::nullopt;
    return parts_->scene.file;
}

std::vector<fs::path> Scene::files() const {
    std::vector<fs::path> files = scene::files_read(parts_->scene);
    if (!file()) std::erase(files, parts_->scene.file);
    return files;
}

int Scene::frames() const { return parts_->scene.timeline.frames; }

double Scene::frames_per_second() const {
    const animation::FrameRate fps = parts_->scene.timeline.fps;
    return double(fps.numerator) / double(fps.denominator);
}

double Scene::time(int frame) const { return parts_->scene.timeline.time(frame); }
int Scene::poster() const { return parts_->scene.output.poster; }
int Scene::width() const { return parts_->scene.output.width; }
int Scene::height() const { return parts_->scene.output.height; }
bool Scene::is_cut() const { return !parts_->scene.sections.empty(); }

std::string Scene::costs() const {
    const scene::Scene& scene = parts_->scene;
    std::vector<std::string> costs;
    const int samples = scene.output.samples;
    if (samples > 1)
        costs.push_back(fmt::format("{} samples a pixel (--set output.samples=1)", samples));
    int depth = 0;
    bool mirrors = false, certifies = false;
    std::size_t operations = 0;
    for (const scene::Surface& surface : scene.surfaces) {
        if (surface.material.glass) depth = std::max(depth, surface.material.glass->depth);
        mirrors |= surface.material.reflection == scene::Material::Reflection::self;
        certifies |= surface.isolation.certify;
        operations = std::max(operations, surface.field->value.instructions.size());
    }
    if (depth > 0) costs.push_back(fmt::format("glass {} rays deep (material.glass.depth)", depth));
    if (mirrors) costs.emplace_back("mirrors (material.reflection)");
    if (certifies) costs.emplace_back("proofs (--certify)");
    constexpr std::size_t is_a_lot = 2000;
    if (operations > is_a_lot)
        costs.push_back(fmt::format("a formula of {} operations", operations));
    costs.push_back(fmt::format("{}x{} pixels (--size)", width(), height()));
    return fmt::format("{}", fmt::join(costs, ", "));
}

std::vector<std::string> Scene::surfaces() const { return scene::surface_names(parts_->scene); }

std::map<std::string, double> Scene::parameters(int frame, const std::string& surface) const {
    return with_errors([&] {
        const animation::Animation& animation = surface_of(parts_->scene, surface).animation;
        const animation::Values values = animation.at(time(api::checked_frame(frame)));
        std::map<std::string, double> parameters;
        for (std::size_t k = 0; k < animation.nameable(); ++k)
            parameters[animation.tracks()[k].name] = values.tracks[k];
        return parameters;
    });
}

} // namespace isomotion
