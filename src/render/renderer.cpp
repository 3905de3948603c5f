#include "render/renderer.h"

#include <algorithm>

#include "gpu/buffer.h"
#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/query.h"
#include "gpu/target.h"
#include "render/blocks.h"
#include "render/fingerprint.h"

namespace isomotion::render {
namespace {

enum Binding : unsigned { binding_frame, binding_parameters, binding_shading, binding_arrays };
enum Unit : int { unit_state_0, unit_state_1, unit_arrays };

// An array's elements on the GPU, in whichever storage the assembly chose.
class ArrayBuffer {
public:
    explicit ArrayBuffer(const synthesis::ArrayStorage& storage) {
        const auto texels = std::size_t(storage.capacity) * std::size_t(storage.texels);
        if (storage.kind == synthesis::ArrayStorage::Kind::uniform_block) {
            block_.emplace(texels * sizeof(glm::vec4));
        } else {
            buffer_.emplace(texels);
        }
    }
    void update(std::span<const glm::vec4> texels) {
        if (texels.empty()) return;
        if (block_) block_->update(std::as_bytes(texels));
        if (buffer_) buffer_->update(texels);
    }
    void bind(std::size_t index) const {
        if (block_) block_->bind(binding_arrays + unsigned(index));
        if (buffer_) buffer_->bind(unit_arrays + int(index));
    }

private:
    std::optional<gpu::UniformBuffer> block_;
    std::optional<gpu::TextureBuffer> buffer_;
};

// What `layers` of EXR an attachment of the shade pass fills, and from which components.
std::vector<image::Channel*> targets_of(image::Frame& frame, synthesis::Channel channel) {
    std::vector<image::Channel*> targets;
    for (const auto& entry : synthesis::channel_names()) {
        if (entry.channel != channel) continue;
        for (const auto layer : entry.layers) {
            const auto it = std::find_if(frame.channels.begin(), frame.channels.end(),
                                         [&](const auto& c) { return c.name == layer; });
            targets.push_back(it == frame.channels.end() ? nullptr : &*it);
        }
    }
    return targets;
}

} // namespace

struct Renderer::Parts {
    Parts(gpu::Context& made_in, const scene::Scene& drawn, RenderOptions wanted)
        : context(made_in)
        , scene(drawn)
        , options(std::move(wanted))
        , shaders(synthesis::assemble(scene, options.channels))
        , plan(make_plan())
        , march(shaders.vertex, shaders.march, "march")
        , active(shaders.vertex, shaders.active, "active")
        , shade(shaders.vertex, shaders.shade, "shade")
        , rays_even(plan.tile_width, plan.tile_height, 2)
        , rays_odd(plan.tile_width, plan.tile_height, 2)
        , result(plan.tile_width, plan.tile_height, 2 + int(shaders.attachments.size()))
        , frame(sizeof(FrameBlock))
        , parameters(std::size_t(shaders.parameter_vectors + shaders.count_vectors) * 16)
        , shading((7 + 2 * scene.lights.size()) * sizeof(glm::vec4)) {
        for (const auto& storage : shaders.arrays) arrays.emplace_back(storage);
        for (const gpu::Program* program : {&march, &active, &shade}) connect(*program);
        pixels.resize(std::size_t(plan.tile_width) * std::size_t(plan.tile_height) * 4);
    }

    MarchPlan make_plan() const {
        std::vector<int> counts;
        for (const auto& array : shaders.arrays) counts.push_back(array.capacity);
        const formula::Field& field = *scene.surface.field;
        formula::Cost cost =
            formula::cost(shaders.samples_derivative ? field.along : field.value, counts);
        if (!shaders.march_takes_gradient) {
            // The shade pass evaluates the gradient once; it too must fit the loop limit.
            cost.iterations =
                std::max(cost.iterations, formula::cost(field.gradient, counts).iterations);
        }
        constexpr int largest_tile = 2048;
        const MarchPlan fitting =
            plan_march(cost, options.width, options.height,
                       std::min(largest_tile, context.info().max_texture_size));
        return options.plan.value_or(fitting);
    }

    void connect(const gpu::Program& program) const {
        program.bind_block("Frame", binding_frame);
        program.bind_block("Parameters", binding_parameters);
        program.bind_block("Shading", binding_shading);
        program.bind_sampler("state_texture_0", unit_state_0);
        program.bind_sampler("state_texture_1", unit_state_1);
        for (std::size_t a = 0; a < shaders.arrays.size(); ++a) {
            const auto& storage = shaders.arrays[a];
            if (storage.kind == synthesis::ArrayStorage::Kind::uniform_block) {
                program.bind_block(storage.name + "_block", binding_arrays + unsigned(a));
            } else {
                program.bind_sampler(storage.name, unit_arrays + int(a));
            }
        }
    }

    void upload(const scene::SceneAt& now, const scene::Aim& aim) {
        const FrameBlock block = frame_block(scene, now, options.width, options.height, aim);
        frame.update(std::as_bytes(std::span(&block, 1)));
        parameters.update(parameter_block(shaders, now));
        const auto shades = shading_block(scene, now, options.width, options.height);
        shading.update(std::as_bytes(std::span(shades)));
        if (scene.material.inside) shade.set("inside_color", glm::vec3(now.inside_color));
        frame.bind(binding_frame);
        parameters.bind(binding_parameters);
        shading.bind(binding_shading);
        for (std::size_t a = 0; a < arrays.size(); ++a) {
            arrays[a].update(array_texels(scene, shaders, now, a));
            arrays[a].bind(a);
        }
    }

    // Marches the rays of a tile to their ends; returns the target that holds them.
    const gpu::Target& march_tile(const gpu::Rectangle& tile, int& passes) {
        const gpu::Rectangle viewport{0, 0, tile.width, tile.height};
        const glm::ivec2 corner(tile.x, tile.y);
        march.set("tile_origin", corner);
        march.set("evaluations_per_pass", plan.evaluations_per_pass);
        const gpu::Target *from = &rays_odd, *to = &rays_even;
        for (bool first = true;; first = false) {
            to->bind();
            gpu::set_viewport(viewport);
            from->texture(0).bind(unit_state_0);
            from->texture(1).bind(unit_state_1);
            march.set("first_pass", first ? 1 : 0);
            march.use();
            triangle.draw();
            ++passes;

            to->texture(0).bind(unit_state_0);
            to->texture(1).bind(unit_state_1);
            result.bind();
            gpu::set_viewport(viewport);
            active.use();
            still_active.begin();
            triangle.draw();
            still_active.end();
            if (!still_active.any_passed()) return *to;
            std::swap(from, to);
        }
    }

    void shade_tile(const gpu::Rectangle& tile, const gpu::Target& rays) {
        rays.texture(0).bind(unit_state_0);
        rays.texture(1).bind(unit_state_1);
        result.bind();
        gpu::set_viewport({0, 0, tile.width, tile.height});
        shade.set("tile_origin", glm::ivec2(tile.x, tile.y));
        shade.use();
        triangle.draw();
    }

    // Copies components of one attachment into channels, rows from the top.
    void read_tile(const gpu::Rectangle& tile, int attachment,
                   const std::vector<image::Channel*>& channels) {
        const auto count = std::size_t(tile.width) * std::size_t(tile.height) * 4;
        result.read(attachment, 0, 0, tile.width, tile.height, std::span(pixels).first(count));
        for (std::size_t c = 0; c < channels.size(); ++c) {
            if (!channels[c]) continue;
            for (int y = 0; y < tile.height; ++y) {
                const int row = options.height - 1 - (tile.y + y);
                float* to = channels[c]->samples.data() +
                            std::size_t(row) * std::size_t(options.width) + std::size_t(tile.x);
                const float* from =
                    pixels.data() + std::size_t(y) * std::size_t(tile.width) * 4 + c;
                for (int x = 0; x < tile.width; ++x) to[x] = from[4 * x];
            }
        }
    }

    image::Frame blank_frame() const {
        image::Frame blank;
        blank.width = options.width;
        blank.height = options.height;
        const auto area = std::size_t(options.width) * std::size_t(options.height);
        const auto add = [&](std::string_view name) {
            blank.channels.push_back({std::string(name), std::vector<float>(area)});
        };
        for (const char* name : {"R", "G", "B", "A"}) add(name);
        for (const auto& entry : synthesis::channel_names()) {
            if (!wants(entry.channel)) continue;
            for (const auto layer : entry.layers) add(layer);
        }
        return blank;
    }

    bool wants(synthesis::Channel channel) const {
        const auto& all = options.channels;
        return std::find(all.begin(), all.end(), channel) != all.end();
    }

    // Adds up the record of the tile just read into `pixels`.
    void count_tile(const gpu::Rectangle& tile, Picture& picture) const {
        for (std::size_t k = 0; k < std::size_t(tile.width) * std::size_t(tile.height); ++k) {
            ++picture.verdicts[std::size_t(pixels[4 * k])];
            picture.evaluations += std::int64_t(pixels[4 * k + 1]);
        }
    }

    gpu::Context& context;
    scene::Scene scene;
    RenderOptions options;
    synthesis::Shaders shaders;
    MarchPlan plan;
    gpu::Program march, active, shade;
    gpu::Target rays_even, rays_odd, result;
    gpu::UniformBuffer frame, parameters, shading;
    std::vector<ArrayBuffer> arrays;
    gpu::Fullscreen triangle;
    gpu::SamplesQuery still_active;
    std::vector<float> pixels; // of one attachment of a tile
};

Renderer::Renderer(gpu::Context& context, const scene::Scene& scene, RenderOptions options)
    : parts_(
          (context.make_current(), std::make_unique<Parts>(context, scene, std::move(options)))) {}

Renderer::~Renderer() = default;

const MarchPlan& Renderer::plan() const { return parts_->plan; }

Picture Renderer::draw(const scene::SceneAt& now, const scene::Aim& aim) {
    Parts& p = *parts_;
    const auto begin = std::chrono::steady_clock::now();
    p.context.make_current();
    Picture picture;
    picture.frame = p.blank_frame();
    p.upload(now, aim);
    const auto channel = [&](std::size_t k) { return &picture.frame.channels[k]; };
    std::vector<image::Channel*> record;
    for (const auto kind : {synthesis::Channel::verdict, synthesis::Channel::evaluations}) {
        record.push_back(targets_of(picture.frame, kind)[0]);
    }
    for (int y = 0; y < p.options.height; y += p.plan.tile_height) {
        for (int x = 0; x < p.options.width; x += p.plan.tile_width) {
            const gpu::Rectangle tile{x, y, std::min(p.plan.tile_width, p.options.width - x),
                                      std::min(p.plan.tile_height, p.options.height - y)};
            p.shade_tile(tile, p.march_tile(tile, picture.passes));
            p.read_tile(tile, 0, {channel(0), channel(1), channel(2), channel(3)});
            p.read_tile(tile, 1, record);
            p.count_tile(tile, picture);
            for (std::size_t a = 0; a < p.shaders.attachments.size(); ++a) {
                p.read_tile(tile, 2 + int(a), targets_of(picture.frame, p.shaders.attachments[a]));
            }
        }
    }
    picture.drawing = std::chrono::steady_clock::now() - begin;
    return picture;
}

std::string Renderer::fingerprint(const scene::SceneAt& now, const scene::Aim& aim) const {
    const Parts& p = *parts_;
    Fingerprint print;
    print.add(p.shaders.march).add(p.shaders.shade);
    const FrameBlock block = frame_block(p.scene, now, p.options.width, p.options.height, aim);
    print.add_values(std::span<const FrameBlock>(&block, 1));
    print.add(parameter_block(p.shaders, now));
    const auto shades = shading_block(p.scene, now, p.options.width, p.options.height);
    print.add_values(std::span<const glm::vec4>(shades));
    print.add_values(std::span<const glm::dvec3>(&now.inside_color, 1));
    for (std::size_t a = 0; a < p.shaders.arrays.size(); ++a) {
        const auto texels = array_texels(p.scene, p.shaders, now, a);
        print.add_values(std::span<const glm::vec4>(texels));
    }
    const std::array size{p.options.width, p.options.height};
    print.add_values(std::span<const int>(size));
    for (const auto wanted : p.options.channels) print.add(std::to_string(int(wanted)));
    return print.text();
}

} // namespace isomotion::render
