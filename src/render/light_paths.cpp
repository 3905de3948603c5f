#include "render/light_paths.h"

#include <algorithm>

#include "synthesis/paths_text.h"

namespace isomotion::render {
namespace {

using synthesis::Role;

constexpr int textures_of_paths = 5;     // shaders/paths/path.glsl
constexpr int textures_of_path_ends = 4; // shaders/surfaces/nearest.glsl

} // namespace

const scene::SceneAt& surface_of(const scene::SceneAt& now, int index) {
    return index == 0 ? now : now.others[std::size_t(index - 1)];
}

std::vector<glm::vec4> matters_at(const scene::SceneAt& now, const scene::Among& among,
                                  double unit) {
    std::vector<glm::vec4> matters(2 * std::size_t(among.count), glm::vec4(0));
    for (std::size_t rank = 0; rank < among.matters.size(); ++rank) {
        const int k = among.matters[rank];
        const scene::GlassAt& glass = surface_of(now, k).glass;
        matters[2 * std::size_t(k)] = glm::dvec4(glass.ior, double(rank), 0, 0);
        matters[2 * std::size_t(k) + 1] = glm::dvec4(unit * glass.absorption, 0);
    }
    return matters;
}

LightPaths::LightPaths(std::vector<SurfacePasses*> all)
    : all_(std::move(all))
    , kept_(all_.front()->plan.march.tile_width, all_.front()->plan.march.tile_height,
            textures_of_paths)
    , gone_on_(kept_.width(), kept_.height(), textures_of_paths)
    , ends_(all_.front()->plan.march, textures_of_path_ends)
    , beyond_(kept_.width(), kept_.height())
    , ended_(kept_.width(), kept_.height(), textures_of_path_ends)
    , mask_(kept_) {
    for (const SurfacePasses* one : all_) rays_.emplace_back(one->passes, one->plan.march);
    for (const gpu::Target* target : {&gone_on_, &ends_.targets[0], &ends_.targets[1], &beyond_})
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

bool LightPaths::any_goes_on(const gpu::Rectangle& tile) {
    SurfacePasses& first = *all_.front();
    bind(first, ends_.last(), nullptr);
    mask_.set(gone_on_, [&] { first.table.draw(first.table.program(Role::glass_mask), tile); });
    mask_.apply(gone_on_, [&] {
        still_active_.begin();
        first.table.draw(first.table.program(Role::glass_active), tile);
        still_active_.end();
    });
    return still_active_.passed() != 0;
}

void LightPaths::find_ends(const gpu::Rectangle& tile, int& draws) {
    for (std::size_t k = 0; k < all_.size(); ++k) {
        SurfacePasses& one = *all_[k];
        bind(one, ends_.last(), nullptr);
        // What counts active rays is masked as they are: states elsewhere are older.
        mask_.apply(rays_[k].even, [&] {
            one.marcher.march(one.table, Role::glass, tile, rays_[k], gone_on_, draws);
        });
        mask_.apply(ends_.next(),
                    [&] { one.table.draw(one.table.program(Role::glass_end), tile); });
    }
}

// Surfaces draw over each other, the one whose matter counts before all others last.
template<class Draw> void LightPaths::look_beyond(const gpu::Target& ends, const Draw& draw) {
    beyond_.clear(0);
    const std::vector<int>& matters = all_.front()->scene.among.matters;
    for (auto k = matters.rbegin(); k != matters.rend(); ++k) {
        SurfacePasses& one = *all_[std::size_t(*k)];
        bind(one, ends, nullptr);
        draw(one.table);
    }
}

void LightPaths::go_on(const gpu::Rectangle& tile, const gpu::Texture* environment) {
    for (SurfacePasses* one : all_) {
        bind(*one, ends_.last(), environment);
        mask_.apply(gone_on_, [&] { one->table.draw(one->table.program(Role::glass_next), tile); });
    }
    SurfacePasses& first = *all_.front();
    first.bind();
    first.table.bind_numbered("glass_texture", gone_on_);
    mask_.apply(kept_, [&] { first.table.draw(first.table.program(Role::glass_copy), tile); });
}

void LightPaths::trace(const gpu::Target& eye_ends, const gpu::Rectangle& tile,
                       const gpu::Texture* environment, int& draws) {
    const int depth = all_.front()->scene.among.depth;
    look_beyond(eye_ends, [&](PassTable& table) {
        table.draw(table.program(Role::glass_beyond), tile, beyond_);
    });
    for (SurfacePasses* one : all_) {
        bind(*one, eye_ends, environment);
        const gpu::Program& first = one->table.program(Role::glass_first);
        first.set("rays_left", depth);
        one->table.draw(first, tile, kept_);
    }
    // Crossings of bounds are no rays of the depth, and the last one ends a path.
    const int most = depth + synthesis::most_crossings + 1;
    for (int ray = 0; ray <= most && any_goes_on(tile); ++ray) {
        find_ends(tile, draws);
        look_beyond(ends_.last(), [&](PassTable& table) {
            mask_.apply(beyond_, [&] { table.draw(table.program(Role::glass_beyond), tile); });
        });
        go_on(tile, environment);
    }
}

const gpu::Target& LightPaths::draw_ends(const gpu::Rectangle& tile) {
    SurfacePasses& first = *all_.front();
    bind(first, ends_.last(), nullptr);
    first.table.draw(first.table.program(Role::glass_ground), tile, ended_);
    return ended_;
}

} // namespace isomotion::render
