#include "render/pass_table.h"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "gpu/compute.h"

namespace isomotion::render {
namespace {

// What fills a block of a pass. Proofs see bounds that are wider by what rounding may do.
std::string block_for(const shader::Pass& pass, const std::string& block) {
    return block == "Frame" && shader::is_proof(pass.role) ? "ProofFrame" : block;
}

gpu::Program compiled(const shader::Pass& pass) {
    return pass.stage == shader::Stage::compute ? gpu::Program::compute(pass.text, pass.name)
                                                : gpu::Program(pass.vertex, pass.text, pass.name);
}

// Runs the compute shader in use, one invocation for each place, with its images in `target`.
void dispatch(glm::ivec2 places, const gpu::Target& target) {
    for (int k = 0; k < target.attachments(); ++k) gpu::bind_image(target.texture(k), k);
    gpu::dispatch((places + shader::workgroup_side - 1) / shader::workgroup_side);
}

void set_on(const gpu::Program& program, const shader::Uniforms& uniforms) {
    for (const shader::Uniform& uniform : uniforms) {
        std::visit(
            [&](const auto& value) {
                using Value = std::decay_t<decltype(value)>;
                if constexpr (std::is_same_v<Value, std::vector<glm::vec4>>) {
                    program.set(uniform.name, std::span<const glm::vec4>(value));
                } else {
                    program.set(uniform.name, value);
                }
            },
            uniform.value);
    }
}

} // namespace

PassTable::PassTable(const shader::Passes& passes)
    : passes_(passes)
    , programs_(passes.list.size()) {
    for (const shader::Pass& pass : passes.list) {
        for (const auto& sampler : pass.samplers) units_.emplace(sampler, int(units_.size()));
        for (const auto& block : pass.blocks) {
            bindings_.emplace(block_for(pass, block), int(bindings_.size()));
        }
    }
    // Two more are for the probe of the driver's doubles: spare_unit().
    constexpr int most = gpu::editing_unit - 2;
    if (int(units_.size()) > most) {
        throw std::length_error(fmt::format("the scene's passes read {} textures; {} can be bound",
                                            units_.size(), most));
    }
    for (std::size_t k = 0; k < passes.list.size(); ++k) {
        if (!shader::is_exceptional(passes.list[k].when)) compile(k);
    }
}

const gpu::Program& PassTable::compile(std::size_t index) {
    const shader::Pass& pass = passes_.list[index];
    const gpu::Program& program = programs_[index].emplace(compiled(pass));
    connect(pass, program);
    set_on(program, uniforms_);
    return program;
}

void PassTable::connect(const shader::Pass& pass, const gpu::Program& program) const {
    for (const auto& sampler : pass.samplers) {
        program.bind_sampler(sampler, units_.find(sampler)->second);
    }
    for (const auto& block : pass.blocks) {
        program.bind_block(block, unsigned(bindings_.find(block_for(pass, block))->second));
    }
}

const gpu::Program& PassTable::program(shader::Role role, int level) {
    const auto index = std::size_t(&passes_.at(role, level) - passes_.list.data());
    const auto& known = programs_[index];
    return known ? *known : compile(index);
}

void PassTable::set(const shader::Uniforms& uniforms) {
    uniforms_ = uniforms;
    for (const auto& program : programs_) {
        if (program) set_on(*program, uniforms_);
    }
}

void PassTable::bind(std::string_view sampler, const gpu::Texture& texture) const {
    if (const auto unit = units_.find(sampler); unit != units_.end()) texture.bind(unit->second);
}

void PassTable::bind(std::string_view sampler, const gpu::TextureBuffer& buffer) const {
    if (const auto unit = units_.find(sampler); unit != units_.end()) buffer.bind(unit->second);
}

void PassTable::bind(std::string_view sampler, const gpu::IntegerBuffer& buffer) const {
    if (const auto unit = units_.find(sampler); unit != units_.end()) buffer.bind(unit->second);
}

void PassTable::bind_numbered(const std::string& sampler, const gpu::Target& target) const {
    for (int k = 0; k < target.attachments(); ++k) {
        bind(fmt::format("{}_{}", sampler, k), target.texture(k));
    }
}

void PassTable::bind(std::string_view block, const gpu::UniformBuffer& buffer) {
    const auto binding = bindings_.find(block);
    if (binding == bindings_.end()) return;
    buffer.bind(unsigned(binding->second));
    bound_.insert_or_assign(binding->first, &buffer);
}

PassTable::Instead::Instead(PassTable& table, std::string block, const gpu::UniformBuffer& buffer)
    : table_(table)
    , block_(std::move(block))
    , before_(table.bound_[block_]) {
    table_.bind(block_, buffer);
}

PassTable::Instead::~Instead() {
    if (before_) table_.bind(block_, *before_);
}

// Draws `width` x `height` pixels from the tile's lower left one on.
void PassTable::place(const gpu::Program& program, const gpu::Rectangle& tile, int width,
                      int height) const {
    gpu::set_viewport({corner_.x, corner_.y, width, height});
    // Shaders take the target's lower left pixel for the tile's.
    program.set("tile_origin", glm::ivec2(tile.x, tile.y) - corner_);
}

void PassTable::draw(const gpu::Program& program, const gpu::Rectangle& tile) const {
    place(program, tile, tile.width, tile.height);
    triangle_.draw();
}

void PassTable::draw(const gpu::Program& program, const gpu::Rectangle& tile,
                     const gpu::Target& target) const {
    target.bind();
    draw(program, tile);
}

void PassTable::draw(const gpu::Program& program, const gpu::Rectangle& tile,
                     const gpu::Rectangles& parts) const {
    place(program, tile, tile.width, tile.height);
    program.set("pixel_of_viewport", 2.0f / glm::vec2(tile.width, tile.height));
    bind("rectangles", parts.words());
    parts.draw();
}

void PassTable::draw(const gpu::Program& program, const gpu::Rectangle& tile,
                     const gpu::Squares& squares) const {
    // A point is drawn only if its middle lies in the viewport.
    const int width = (tile.width + 7) / 8 * 8, height = (tile.height + 7) / 8 * 8;
    place(program, tile, width, height);
    program.set("pixel_of_viewport", 2.0f / glm::vec2(width, height));
    bind("squares", squares.words());
    squares.draw();
}

void PassTable::march(const gpu::Program& program, const gpu::Rectangle& tile,
                      const gpu::Target& target, const gpu::Rectangles* parts) const {
    timed([&] { march_untimed(program, tile, target, parts); });
}

void PassTable::march_untimed(const gpu::Program& program, const gpu::Rectangle& tile,
                              const gpu::Target& target, const gpu::Rectangles* parts) const {
    if (passes_.stage == shader::Stage::fragment && parts) {
        target.bind();
        return draw(program, tile, *parts);
    }
    if (passes_.stage == shader::Stage::fragment) return draw(program, tile, target);
    const glm::ivec2 size(tile.width, tile.height);
    program.set("tile_origin", glm::ivec2(tile.x, tile.y));
    program.set("tile_size", size);
    dispatch(size, target);
}

void PassTable::compute_beams(const gpu::Program& program, const gpu::Rectangle& blocks,
                              const gpu::Target& results) const {
    program.set("blocks", glm::ivec4(blocks.x, blocks.y, blocks.width, blocks.height));
    dispatch({blocks.width, blocks.height}, results);
}

} // namespace isomotion::render
