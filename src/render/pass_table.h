// The passes of a scene as programs of one context: compiled, connected to their textures and
// uniform blocks, and ready to run.
//
// Each sampler name has one texture unit and each block one binding. This class alone assigns them,
// in the order in which the passes declare them. Passes that are rarely needed
// (shader::is_exceptional) are compiled when they are first used.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "gpu/buffer.h"
#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/rectangles.h"
#include "gpu/squares.h"
#include "gpu/target.h"
#include "render/ray_clock.h"
#include "shader/pass.h"
#include "shader/uniform.h"

namespace isomotion::render {

class PassTable {
public:
    // `passes` must outlive it. Throws gpu::CompileError, and std::length_error if the passes read
    // more textures than there are units.
    explicit PassTable(const shader::Passes& passes);

    bool has(shader::Role role) const { return passes_.has(role); }
    const gpu::Program& program(shader::Role role, int level = 0);

    // Sets these uniforms in every program, including those compiled later.
    void set(const shader::Uniforms& uniforms);

    // Binds textures that the passes read by these names; "state_texture" is numbered from 0.
    void bind(std::string_view sampler, const gpu::Texture& texture) const;
    void bind(std::string_view sampler, const gpu::TextureBuffer& buffer) const;
    void bind(std::string_view sampler, const gpu::IntegerBuffer& buffer) const;
    void bind_numbered(const std::string& sampler, const gpu::Target& target) const;

    // The first of two texture units that no pass reads.
    int spare_unit() const { return int(units_.size()); }

    // Binds uniform blocks. Passes of proofs read "ProofFrame" where others read "Frame".
    void bind(std::string_view block, const gpu::UniformBuffer& buffer);

    // Binds another buffer to a block during its lifetime.
    class [[nodiscard]] Instead {
    public:
        Instead(PassTable& table, std::string block, const gpu::UniformBuffer& buffer);
        ~Instead();
        Instead(const Instead&) = delete;
        Instead& operator=(const Instead&) = delete;

    private:
        PassTable& table_;
        std::string block_;
        const gpu::UniformBuffer* before_;
    };

    // Where tiles begin in their targets, from now on: the passes below are drawn from there.
    void begin_tiles_at(glm::ivec2 corner) { corner_ = corner; }
    glm::ivec2 corner() const { return corner_; }
    // Where a tile lies in its targets.
    gpu::Rectangle in_targets(const gpu::Rectangle& tile) const {
        return {corner_.x, corner_.y, tile.width, tile.height};
    }

    // Runs a fragment pass over a tile in the bound target, or in `target`. `tile` is the place of
    // that area in the picture.
    void draw(const gpu::Program& program, const gpu::Rectangle& tile) const;
    void draw(const gpu::Program& program, const gpu::Rectangle& tile,
              const gpu::Target& target) const;
    // The same over rectangles in that area, for passes that are drawn so (shader::Cover).
    void draw(const gpu::Program& program, const gpu::Rectangle& tile,
              const gpu::Rectangles& parts) const;
    // Runs one of a pass over squares, which may reach over the tile's upper and right edges.
    void draw(const gpu::Program& program, const gpu::Rectangle& tile,
              const gpu::Squares& squares) const;
    // Runs a pass of rays, in the stage that the passes were assembled for; `target` receives the
    // states. `parts`: what fragments are drawn over, for passes that are drawn so.
    void march(const gpu::Program& program, const gpu::Rectangle& tile, const gpu::Target& target,
               const gpu::Rectangles* parts = nullptr) const;

    // Runs a compute shader of beams for these blocks.
    void compute_beams(const gpu::Program& program, const gpu::Rectangle& blocks,
                       const gpu::Target& results) const;

    // Later passes of rays take their time by this clock, which must outlive them.
    void time_rays_by(RayClock& clock) { clock_ = &clock; }
    // Draws of beams and rays, which take the clock's time if there is one.
    template<typename Draws> void timed(const Draws& draws) const {
        if (clock_) return clock_->time(draws);
        draws();
    }

private:
    void place(const gpu::Program& program, const gpu::Rectangle& tile, int width,
               int height) const;
    void march_untimed(const gpu::Program& program, const gpu::Rectangle& tile,
                       const gpu::Target& target, const gpu::Rectangles* parts) const;

    using Numbers = std::map<std::string, int, std::less<>>;

    const gpu::Program& compile(std::size_t index);
    void connect(const shader::Pass& pass, const gpu::Program& program) const;

    const shader::Passes& passes_;
    std::vector<std::optional<gpu::Program>> programs_; // indexed as passes_.list
    Numbers units_, bindings_;
    std::map<std::string, const gpu::UniformBuffer*, std::less<>> bound_;
    shader::Uniforms uniforms_; // as set last
    gpu::Fullscreen triangle_;
    glm::ivec2 corner_{0};
    RayClock* clock_ = nullptr;
};

} // namespace isomotion::render
