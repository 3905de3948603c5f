#include "scenes/drawn.h"

#include <cmath>

#include <fmt/format.h>

#include "render/exposure.h"
#include "scene/reading/load.h"
#include "shader/assemble.h"

namespace isomotion::scenes {
namespace {

struct Layer {
    const char *name, *layer; // in a statement, and in the picture
};
constexpr Layer layers[] = {{"R", "R"},
                            {"G", "G"},
                            {"B", "B"},
                            {"A", "A"},
                            {"Z", "Z"},
                            {"x", "P.X"},
                            {"y", "P.Y"},
                            {"z", "P.Z"},
                            {"nx", "N.X"},
                            {"ny", "N.Y"},
                            {"nz", "N.Z"},
                            {"verdict", "verdict"},
                            {"evaluations", "evaluations"},
                            {"surface", "surface"},
                            {"cap", "cap"},
                            {"proof", "proof"},
                            {"velocity", "velocity.N"},
                            {"velocity_x", "velocity.X"},
                            {"velocity_y", "velocity.Y"}};

constexpr const char* of_every_pixel[] = {"hit", "found", "u",  "v",  "column", "row",   "ox",
                                          "oy",  "oz",    "dx", "dy", "dz",     "radius"};

constexpr const char* totals[] = {"hits",      "finds",      "misses",       "nans",   "limits",
                                  "passes",    "total",      "eye",          "shadow", "path",
                                  "occlusion", "undecided",  "most_shadow",  "width",  "height",
                                  "by_place",  "have_lists", "take_gradient"};

render::Picture picture_of(gpu::Context& context, const scene::Scene& scene,
                           const scene::SceneAt& now, const Look& look, int frame) {
    using shader::Channel;
    render::RenderOptions options{scene.output.width, scene.output.height};
    options.channels = {Channel::depth, Channel::normal, Channel::position, Channel::verdict,
                        Channel::evaluations};
    if (scene.surfaces.size() > 1) options.channels.push_back(Channel::surface);
    if (!now.sections.empty()) options.channels.push_back(Channel::cap);
    options.channels.insert(options.channels.end(), look.channels.begin(), look.channels.end());
    options.plan = look.plan;
    options.stage = look.stage;
    render::Renderer renderer(context, scene, options);
    if (scene.output.samples > 1) return render::expose(renderer, scene, frame);
    if (!renderer.needs_motion()) return renderer.draw(now);
    const render::Motion motion = render::motion_about(scene, frame);
    return renderer.draw(now, {}, &motion);
}

std::vector<std::string> prefixed(const std::string& prefix, std::span<const char* const> names) {
    std::vector<std::string> all;
    for (const char* name : names) all.push_back(prefix + name);
    return all;
}

} // namespace

std::string key_of(const std::string& scene, const Look& look) {
    std::string key = look.gallery + with_values(scene, look.with);
    for (const std::string& setting : look.set) key += "\n--set " + setting;
    for (const shader::Channel channel : look.channels) key += fmt::format("\n{}", int(channel));
    const render::MarchPlan plan = look.plan.value_or(render::MarchPlan{});
    return key + fmt::format("\n{} {} {} {} {}", look.frame, int(look.stage), plan.tile_width,
                             plan.tile_height, plan.evaluations_per_pass);
}

Drawn draw(gpu::Context& context, const std::string& scene, const std::string& file,
           const Look& look) {
    using scene::Reach;
    Drawn drawn;
    drawn.scene = look.gallery.empty() ? scene::load_text(with_values(scene, look.with), file,
                                                          look.set, Reach::anywhere)
                                       : scene::load(look.gallery, look.set);
    const int frame = look.frame == 0 ? drawn.scene.output.poster : look.frame;
    drawn.now = scene::at_frame(drawn.scene, frame);
    drawn.picture = picture_of(context, drawn.scene, drawn.now, look, frame);
    return drawn;
}

PixelNumbers::PixelNumbers(const Drawn& drawn)
    : drawn_(drawn)
    , rays_(scene::rays({drawn.now, 0}, drawn.picture.frame.width, drawn.picture.frame.height))
    , verdicts_(drawn.picture.frame.find("verdict")->samples) {
    for (const auto& [name, layer] : layers)
        if (const image::Channel* channel = drawn.picture.frame.find(layer))
            layers_.emplace_back(name, &channel->samples);
}

std::vector<std::string> PixelNumbers::names(const std::string& prefix) const {
    std::vector<std::string> names;
    for (const auto& [name, samples] : layers_) names.push_back(prefix + name);
    for (const char* name : of_every_pixel) names.push_back(prefix + name);
    return names;
}

void PixelNumbers::add(std::size_t pixel, std::vector<double>& to) const {
    const image::Frame& frame = drawn_.picture.frame;
    for (const auto& [name, samples] : layers_) to.push_back((*samples)[pixel]);
    const auto verdict = render::Verdict(int(verdicts_[pixel]));
    const bool hit = verdict == render::Verdict::hit;
    const auto column = double(pixel % std::size_t(frame.width));
    const auto row = double(pixel / std::size_t(frame.width));
    const double u = 2 * (column + 0.5) / frame.width - 1, v = 1 - 2 * (row + 0.5) / frame.height;
    const glm::dvec3 across = u * rays_.right + v * rays_.up;
    const glm::dvec3 along = rays_.axis + (rays_.parallel ? glm::dvec3(0) : across);
    const scene::PlacementAt& place = drawn_.now.surfaces[0].placement;
    const glm::dvec3 from = place.to_world(rays_.origin + across - along);
    const glm::dvec3 direction = glm::normalize(place.rotate * along);
    for (const double number :
         {double(hit), double(hit || verdict == render::Verdict::zero_gradient), u, v, column, row,
          from.x, from.y, from.z, direction.x, direction.y, direction.z,
          place.scale * drawn_.now.surfaces[0].bounds.radius})
        to.push_back(number);
}

std::vector<std::string> total_names(const std::string& prefix) { return prefixed(prefix, totals); }

void add_totals(const Drawn& drawn, std::vector<double>& to) {
    const render::Picture& picture = drawn.picture;
    const auto of = [&](render::Verdict verdict) { return picture.verdicts[std::size_t(verdict)]; };
    using render::Verdict;
    const std::int64_t hits = of(Verdict::hit);
    for (const std::int64_t count :
         {hits, hits + of(Verdict::zero_gradient), of(Verdict::miss), of(Verdict::nan),
          of(Verdict::step_limit), std::int64_t(picture.passes), picture.evaluations()})
        to.push_back(double(count));
    for (const render::RayCount& kind : picture.rays) to.push_back(double(kind.evaluations));
    const render::RayCount& shadow = picture.rays[std::size_t(render::RayKind::shadow)];
    for (const std::int64_t count :
         {shadow.undecided, shadow.most, std::int64_t(picture.frame.width),
          std::int64_t(picture.frame.height)})
        to.push_back(double(count));
    const bool is_one = drawn.scene.surfaces.size() == 1;
    const shader::Passes passes = is_one ? shader::assemble(drawn.scene) : shader::Passes{};
    for (const bool has : {shader::array_with_grid(passes).has_value(), shader::has_lists(passes),
                           passes.march_takes_gradient})
        to.push_back(is_one ? double(has) : NAN);
}

} // namespace isomotion::scenes
