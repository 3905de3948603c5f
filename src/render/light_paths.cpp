#include "render/light_paths.h"

#include <algorithm>

#include "render/open_squares.h"
#include "scene/surfaces.h"
#include "shader/paths_text.h"

namespace isomotion::render {
namespace {

using shader::Role;

constexpr int textures_of_paths = 5;     // shaders/paths/path.glsl
constexpr int textures_of_path_ends = 4; // shaders/surfaces/nearest.glsl

} // namespace

std::vector<glm::vec4> matters_at(const scene::Scene& scene, const scene::SceneAt& now,
                                  double unit) {
    std::vector<glm::vec4> found(2 * scene.surfaces.size(), glm::vec4(0));
    double rank = 0;
    for (const std::size_t k : scene::matters(scene)) {
        const scene::GlassAt& glass = now.surfaces[k].glass;
        found[2 * k] = glm::dvec4(glass.ior, rank++, 0, 0);
        found[2 * k + 1] = glm::dvec4(unit * glass.absorption, 0);
    }
    return found;
}

LightPaths::LightPaths(std::vector<SurfacePasses*> all)
    : all_(std::move(all))
    , kept_(all_.front()->plan.march.target_width(), all_.front()->plan.march.target_height(),
            textures_of_paths)
    , gone_on_(kept_.width(), kept_.height(), textures_of_paths)
    , ends_(all_.front()->plan.march, textures_of_path_ends)
    , beyond_(kept_.width(), kept_.height())
    , ended_(kept_.width(), kept_.height(), textures_of_path_ends)
    , mask_(kept_) {
    for (const SurfacePasses* one : all_) rays_.emplace_back(one->passes, one->plan.march);
    for (const gpu::Target* target :
         {&gone_on_, &ends_.targets[0], &ends_.targets[1], &beyond_, &ended_})
        mask_.serve(*target);
    for (const RayTargets& rays : rays_) {
        mask_.serve(rays.even);
        mask_.serve(rays.odd);
    }
}

void LightPaths::bind(SurfacePasses& one, const gpu::Target& ends,
                      const gpu::Texture* environment) const {
    one.bind();
    if (environment) one.table.bind("environment_map", *environment);
    one.table.bind_numbered("glass_texture", kept_);
    one.table.bind_numbered("surface_texture", ends);
    one.table.bind("beyond_texture", beyond_.texture(0));
}

// Pixels where no path begins get a path that ends at once, with the eye's light alone.
void LightPaths::begin(const gpu::Target& eye_ends, const gpu::Rectangle& tile,
                       const gpu::Texture* environment) {
    kept_.clear(0);
    kept_.clear(1);
    kept_.clear(2, glm::vec4(1, 1, 1, 0));
    kept_.clear(3);
    kept_.clear(4, glm::vec4(0, 0, 0, 1));
    for (SurfacePasses* one : all_) {
        bind(*one, eye_ends, environment);
        const gpu::Program& first = one->table.program(Role::glass_first);
        first.set("rays_left", scene::depth_of_matters(all_.front()->drawn.scene));
        mask_.set(kept_, [&] { one->table.draw(one->table.program(Role::glass_begins), tile); });
        mask_.apply(kept_, [&] { one->table.draw(first, tile); });
    }
}

gpu::Rectangle LightPaths::around_in_targets() const {
    const glm::ivec2 corner = all_.front()->table.corner();
    return {corner.x + around_.x, corner.y + around_.y, around_.width, around_.height};
}

// Late rays are few, and what they are drawn over costs more than they do.
bool LightPaths::any_goes_on(const gpu::Rectangle& tile) {
    const auto numbers = std::size_t(4 * around_.width * around_.height);
    codes_.resize(numbers + 3); // whole from the code of the first pixel on
    const gpu::Rectangle area = around_in_targets();
    kept_.read(0, area.x, area.y, area.width, area.height, std::span(codes_).first(numbers));
    std::vector<gpu::Rectangle> rows;
    for (int y = 0; y < around_.height; y += OpenSquares::side) {
        rows.push_back({around_.x, around_.y + y, around_.width,
                        std::min(OpenSquares::side, around_.height - y)});
    }
    const auto goes_on = [](float code) { return ((int(code) + 1) & 6) == 2; };
    const OpenSquares open = open_squares(rows, std::span(codes_).subspan(3), goes_on);
    if (open.pixels == 0) return false;
    gpu::Rectangle all = {tile.width, tile.height, 0, 0};
    int right = 0, top = 0;
    for (const gpu::Rectangle& area : open.areas) {
        all.x = std::min(all.x, area.x);
        all.y = std::min(all.y, area.y);
        right = std::max(right, area.x + area.width);
        top = std::max(top, area.y + area.height);
    }
    around_ = {all.x, all.y, right - all.x, top - all.y};
    SurfacePasses& first = *all_.front();
    bind(first, ends_.last(), nullptr);
    mask_.set(gone_on_, [&] { draw_open(first, Role::glass_mask, tile); });
    open_.set(open.areas);
    return true;
}

void LightPaths::draw_open(SurfacePasses& one, Role role, const gpu::Rectangle& tile) {
    one.table.draw(one.table.program(role), tile, open_);
}

void LightPaths::find_ends(const gpu::Rectangle& tile, int& draws) {
    for (std::size_t k = 0; k < all_.size(); ++k) {
        SurfacePasses& one = *all_[k];
        bind(one, ends_.last(), nullptr);
        // Active rays are counted under the same mask: states elsewhere are older.
        mask_.apply(rays_[k].even, [&] {
            one.marcher.march(one.table, Role::glass, tile, rays_[k], gone_on_, draws, &open_);
        });
        mask_.apply(ends_.next(), [&] { draw_open(one, Role::glass_end, tile); });
    }
}

// Surfaces draw over each other, the one whose matter counts before all others last.
void LightPaths::look_beyond(const gpu::Target& ends, const gpu::Rectangle& tile) {
    beyond_.clear(0);
    const std::vector<std::size_t> matters = scene::matters(all_.front()->drawn.scene);
    for (auto k = matters.rbegin(); k != matters.rend(); ++k) {
        SurfacePasses& one = *all_[*k];
        bind(one, ends, nullptr);
        draw_open(one, Role::glass_beyond, tile);
    }
}

void LightPaths::go_on(const gpu::Rectangle& tile, const gpu::Texture* environment) {
    for (SurfacePasses* one : all_) {
        bind(*one, ends_.last(), environment);
        mask_.apply(gone_on_, [&] { draw_open(*one, Role::glass_next, tile); });
    }
    SurfacePasses& first = *all_.front();
    first.bind();
    first.table.bind_numbered("glass_texture", gone_on_);
    mask_.apply(kept_, [&] { draw_open(first, Role::glass_copy, tile); });
}

void LightPaths::trace(const gpu::Target& eye_ends, const gpu::Rectangle& tile,
                       const gpu::Texture* environment, int& draws) {
    around_ = {0, 0, tile.width, tile.height};
    open_.set({&around_, 1});
    beyond_.bind();
    look_beyond(eye_ends, tile);
    begin(eye_ends, tile, environment);
    // Crossings of bounds are no rays of the depth, and the last one ends a path.
    const int most =
        scene::depth_of_matters(all_.front()->drawn.scene) + shader::most_crossings + 1;
    for (int ray = 0; ray <= most && any_goes_on(tile); ++ray) {
        const gpu::Scissor in_area(around_in_targets());
        find_ends(tile, draws);
        mask_.apply(beyond_, [&] { look_beyond(ends_.last(), tile); });
        go_on(tile, environment);
    }
}

const gpu::Target& LightPaths::draw_ends(const gpu::Rectangle& tile) {
    SurfacePasses& first = *all_.front();
    bind(first, ends_.last(), nullptr);
    ended_.clear(1); // compute shaders know no mask
    mask_.set(ended_, [&] { first.table.draw(first.table.program(Role::glass_ended), tile); });
    mask_.apply(ended_, [&] { first.table.draw(first.table.program(Role::glass_ground), tile); });
    return ended_;
}

} // namespace isomotion::render
