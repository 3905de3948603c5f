// The passes of a scene as programs of one context: compiled, connected to their textures and
// uniform blocks, and ready to run.
//
// Each sampler's name has one texture unit and each block's one binding, given out here in the
// order in which the passes declare them; nobody else knows either. Passes that are rarely needed
// (synthesis::is_exceptional) are compiled when they are first asked for.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "synthesis/pass.h"
#include "synthesis/uniform.h"

namespace isomotion::render {

class PassTable {
public:
    // `passes` outlives it. Throws gpu::CompileError; std::length_error if the passes read more
    // textures than there are units.
    explicit PassTable(const synthesis::Passes& passes);

    bool has(synthesis::Role role) const { return passes_.has(role); }
    const gpu::Program& program(synthesis::Role role, int level = 0);

    // Gives these uniforms to every program, those compiled later included.
    void set(const synthesis::Uniforms& uniforms);

    // Textures that the passes read by these names: "state_texture" has the numbers 0 and up.
    void bind(std::string_view sampler, const gpu::Texture& texture) const;
    void bind(std::string_view sampler, const gpu::TextureBuffer& buffer) const;
    void bind(std::string_view sampler, const gpu::IntegerBuffer& buffer) const;
    void bind_numbered(const std::string& sampler, const gpu::Target& target) const;

    // The first of two texture units that no pass reads.
    int spare_unit() const { return int(units_.size()); }

    // Uniform blocks. What a pass reads as "Frame" is "ProofFrame" for passes of proofs.
    void bind(std::string_view block, const gpu::UniformBuffer& buffer);

    // Draws with another buffer in a block for as long as it lives.
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

    // Runs a pass of fragments over the lower left width x height of what is bound to be drawn
    // into, or of `target`. `tile` tells where that is in the picture.
    void draw(const gpu::Program& program, const gpu::Rectangle& tile) const;
    void draw(const gpu::Program& program, const gpu::Rectangle& tile,
              const gpu::Target& target) const;
    // Runs a pass of rays, in the stage that the passes were assembled for; `target` takes the
    // states.
    void march(const gpu::Program& program, const gpu::Rectangle& tile,
               const gpu::Target& target) const;

private:
    using Numbers = std::map<std::string, int, std::less<>>;

    void compile(std::size_t index);
    void connect(const synthesis::Pass& pass, const gpu::Program& program) const;

    const synthesis::Passes& passes_;
    std::vector<std::optional<gpu::Program>> programs_; // as in passes_.list
    Numbers units_, bindings_;
    std::map<std::string, const gpu::UniformBuffer*, std::less<>> bound_;
    synthesis::Uniforms uniforms_; // as set last
    gpu::Fullscreen triangle_;
};

} // namespace isomotion::render
