#include "render/several_surfaces.h"

#include "render/motion.h"
#include "shader/paths_text.h"

namespace isomotion::render {
namespace {

using shader::Role;

constexpr int kept_textures = 4; // of what is kept of an end, see shaders/surfaces/nearest.glsl

// One more where paths may begin before it: shaders/paths/bounds.glsl.
int textures_of_ends(const scene::Scene& scene) {
    return kept_textures + int(shader::follows_paths(scene));
}

// The distance from the eye along the camera's axis to the plane where t is 0, in formula
// coordinates.
double depth_of(const scene::Rays& rays) {
    return glm::dot(rays.axis, glm::normalize(glm::cross(rays.up, rays.right)));
}

} // namespace

shader::Uniforms uniforms_among(const scene::OneSurface& one, const scene::SceneAt& now, int width,
                                int height, const scene::Aim& aim) {
    const scene::OneSurfaceAt own(now, one.index), first(now, 0);
    const scene::PlacementAt& place = own.surface.placement;
    // Differences in double: the planes may be near each other and far from the eye.
    const double own_depth = depth_of(scene::rays(own, width, height, aim));
    const double first_depth = depth_of(scene::rays(first, width, height, aim));
    const double unit = place.scale / first.surface.placement.scale;
    const glm::dvec4 way(unit, (unit * own_depth - first_depth) / own_depth, 0, 0);

    std::vector<glm::vec4> moves;
    for (std::size_t k = 0; k < now.surfaces.size(); ++k) {
        // A place on this surface stays to the bit.
        const auto rows = k == one.index ? std::array{glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0),
                                                      glm::vec4(0, 0, 1, 0)}
                                         : change_of_place(now.surfaces[k].placement, place);
        moves.insert(moves.end(), rows.begin(), rows.end());
    }
    shader::Uniforms uniforms{{"surface_way", glm::vec4(way)}, {"surface_moves", moves}};
    if (!shader::follows_paths(one.scene)) return uniforms;
    uniforms.push_back({"path_moves", std::move(moves)});
    uniforms.push_back({"matters", matters_at(one.scene, now, place.scale)});
    return uniforms;
}

SeveralSurfaces::SeveralSurfaces(std::vector<SurfacePasses*> all)
    : all_(std::move(all))
    , rays_(all_.size())
    , ends_(all_.front()->plan.march, textures_of_ends(all_.front()->drawn.scene)) {
    const MarchPlan& tile = all_.front()->plan.march;
    for (const SurfacePasses* one : all_) {
        eye_.emplace_back(one->passes, tile);
        if (one->passes.has(Role::shadow)) shadow_.emplace_back(one->passes, tile);
        if (one->passes.has(Role::mirror)) mirror_.emplace_back(one->passes, tile);
    }
    if (!mirror_.empty()) begin_mirrors(tile);
    if (all_.front()->passes.has(Role::glass)) begin_paths(tile);
    if (all_.front()->passes.has(Role::occlusion)) open_.emplace(tile, 1);
}

void SeveralSurfaces::begin_mirrors(const MarchPlan& tile) {
    const Relay& mirrored = mirrored_.emplace(tile, kept_textures);
    const gpu::DepthMask& mirrors =
        mirrors_.emplace(seen_.emplace(tile.target_width(), tile.target_height()));
    for (const gpu::Target& target : mirrored.targets) mirrors.serve(target);
    for (const RayTargets& rays : mirror_) {
        mirrors.serve(rays.even);
        mirrors.serve(rays.odd);
    }
}

void SeveralSurfaces::begin_paths(const MarchPlan& tile) {
    const gpu::DepthMask& mask = paths_.emplace(all_).mask();
    mask.serve(seen_.emplace(tile.target_width(), tile.target_height()));
    for (const RayTargets& rays : shadow_) {
        mask.serve(rays.even);
        mask.serve(rays.odd);
    }
}

void SeveralSurfaces::find_ends(const PictureInputs& inputs, const gpu::Rectangle& tile,
                                const gpu::Target& result, int& draws) {
    for (std::size_t k = 0; k < all_.size(); ++k) {
        SurfacePasses& one = *all_[k];
        one.bind();
        one.draw_beams(inputs.surfaces[k], tile);
        one.table.bind_numbered("surface_texture", ends_.last());
        rays_[k] = &one.marcher.march(one.table, Role::march, tile, eye_[k], result, draws);
        one.table.draw(one.table.program(Role::surface), tile, ends_.next());
    }
}

// Where no mirror is seen, nothing reads what mirrored rays would see.
void SeveralSurfaces::see_in_mirrors(const gpu::Rectangle& tile, const gpu::Texture* environment,
                                     int& draws) {
    if (!mirrors_ || !mirrored_ || !seen_) return;
    const gpu::DepthMask& mirrors = *mirrors_;
    Relay& mirrored = *mirrored_;
    const gpu::Target& to = *seen_;
    SurfacePasses& first = *all_.front();
    first.bind();
    first.table.bind_numbered("surface_texture", ends_.last());
    mirrors.set(to, [&] { first.table.draw(first.table.program(Role::mirror_mask), tile); });
    for (std::size_t k = 0; k < all_.size(); ++k) {
        SurfacePasses& one = *all_[k];
        one.bind();
        one.table.bind_numbered("surface_texture", ends_.last());
        mirrors.apply(
            to, [&] { one.marcher.march(one.table, Role::mirror, tile, mirror_[k], to, draws); });
        one.table.bind_numbered("mirrored_texture", mirrored.last());
        mirrors.apply(mirrored.next(),
                      [&] { one.table.draw(one.table.program(Role::mirror_surface), tile); });
    }
    to.clear(0);
    for (std::size_t k = 0; k < all_.size(); ++k) {
        SurfacePasses& one = *all_[k];
        one.bind();
        if (environment) one.table.bind("environment_map", *environment);
        one.table.bind_numbered("state_texture", *rays_[k]);
        one.table.bind_numbered("surface_texture", ends_.last());
        one.table.bind_numbered("mirrored_texture", mirrored.last());
        mirrors.apply(to, [&] { one.table.draw(one.table.program(Role::seen), tile); });
    }
}

// Returns the states of the last surface's shadow rays, which tell all that is hidden from the
// ends.
const gpu::Target* SeveralSurfaces::cast_shadows(const gpu::Target& ends,
                                                 const gpu::Rectangle& tile,
                                                 const gpu::Target& counted_into, int& draws) {
    const gpu::Target* ended = nullptr;
    for (std::size_t k = 0; k < shadow_.size(); ++k) {
        SurfacePasses& one = *all_[k];
        one.bind();
        one.table.bind_numbered("surface_texture", ends);
        if (ended) one.table.bind("shadow_texture", ended->texture(1));
        ended = &one.marcher.march(one.table, Role::shadow, tile, shadow_[k], counted_into, draws);
    }
    return ended;
}

void SeveralSurfaces::look_around(const gpu::Rectangle& tile) {
    if (!open_) return;
    Relay& open = *open_;
    for (SurfacePasses* one : all_) {
        one->bind();
        one->table.bind_numbered("surface_texture", ends_.last());
        one->table.bind("occlusion_texture", open.last().texture(0));
        one->table.draw(one->table.program(Role::occlusion), tile, open.next());
    }
}

// Follows paths to their ends, and shades these.
void SeveralSurfaces::follow_paths(const gpu::Rectangle& tile, const gpu::Texture* environment,
                                   int& draws) {
    if (!paths_ || !seen_) return;
    LightPaths& paths = *paths_;
    const gpu::Target& to = *seen_;
    paths.trace(ends_.last(), tile, environment, draws);
    const gpu::Target& ends = paths.draw_ends(tile);
    // Where the mask has no pixel, nothing reads what there is.
    const gpu::Target* hidden = nullptr;
    paths.mask().apply(ends, [&] { hidden = cast_shadows(ends, tile, paths.spare(), draws); });
    to.clear(0);
    for (std::size_t k = 0; k < all_.size(); ++k) {
        SurfacePasses& one = *all_[k];
        one.bind();
        if (environment) one.table.bind("environment_map", *environment);
        if (hidden) one.table.bind("shadow_texture", hidden->texture(1));
        one.table.bind_numbered("state_texture", *rays_[k]);
        one.table.bind_numbered("glass_texture", paths.light());
        one.table.bind_numbered("mirrored_texture", ends);
        paths.mask().apply(to, [&] { one.table.draw(one.table.program(Role::seen), tile); });
    }
}

std::vector<int> SeveralSurfaces::seen(const gpu::Rectangle& tile) const {
    const std::vector<float> ends = ends_.last().read(3, 0, 0, tile.width, tile.height);
    std::vector<int> indices(ends.size() / 4);
    for (std::size_t k = 0; k < indices.size(); ++k) indices[k] = int(ends[4 * k + 2]);
    return indices;
}

void SeveralSurfaces::draw(const PictureInputs& inputs, const gpu::Rectangle& tile,
                           const gpu::Target& result, const gpu::Texture* environment, int& draws) {
    find_ends(inputs, tile, result, draws);
    see_in_mirrors(tile, environment, draws);
    follow_paths(tile, environment, draws);
    const gpu::Target* hidden = cast_shadows(ends_.last(), tile, result, draws);
    look_around(tile);
    for (std::size_t k = 0; k < all_.size(); ++k) {
        SurfacePasses& one = *all_[k];
        one.bind();
        if (environment) one.table.bind("environment_map", *environment);
        one.table.bind_numbered("state_texture", *rays_[k]);
        one.table.bind_numbered("surface_texture", ends_.last());
        if (seen_) one.table.bind("seen_texture", seen_->texture(0));
        if (hidden) one.table.bind("shadow_texture", hidden->texture(1));
        if (open_) one.table.bind("occlusion_texture", open_->last().texture(0));
        if (paths_) one.table.bind_numbered("glass_texture", paths_->light());
        one.table.draw(one.table.program(Role::shade), tile, result);
    }
}

} // namespace isomotion::render
