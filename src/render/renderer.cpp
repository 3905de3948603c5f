#include "render/renderer.h"

#include <algorithm>
#include <bit>
#include <deque>

#include <fmt/format.h>

#include "base/fingerprint.h"
#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/query.h"
#include "gpu/target.h"
#include "gpu/transfer.h"
#include "image/environment.h"
#include "render/array_buffer.h"
#include "render/beam_pass.h"
#include "render/blocks.h"
#include "render/effect_uniforms.h"
#include "render/element_radius.h"
#include "render/layers.h"
#include "render/light_beams.h"
#include "render/planes.h"
#include "render/ray_pass.h"
#include "render/record.h"
#include "render/scene_plan.h"
#include "render/secondary_rays.h"
#include "render/velocity_pass.h"
#include "render/whole_draw.h"
#include "synthesis/effect_text.h"

namespace isomotion::render {
namespace {

enum Binding : unsigned { binding_frame, binding_parameters, binding_shading, binding_arrays };
enum Unit : int { unit_state_0, unit_state_1, unit_state_2, unit_arrays };

} // namespace

struct Renderer::Parts {
    Parts(gpu::Context& made_in, const scene::Scene& drawn, RenderOptions wanted)
        : context(made_in)
        , scene(drawn)
        , options(std::move(wanted))
        , shaders(synthesis::assemble(scene, options.channels,
                                      choose_stage(options.stage, context.info()),
                                      context.info().has(4, 3), options.finest_beam))
        , plans(plan_scene(scene, shaders, options.width, options.height,
                           context.info().max_texture_size, options.plan))
        , plan(plans.march)
        , one_draw(shaders.stage == synthesis::Stage::fragment && !shaders.whole.empty() &&
                   plan.evaluations_per_pass > 1)
        , record(plan.tile_width * plan.tile_height, !shaders.surface.empty())
        , planes(options.width, options.height)
        , layers(options.channels, shaders.attachments)
        , result(plan.tile_width, plan.tile_height, formats())
        , frame(sizeof(FrameBlock))
        , parameters(std::size_t(shaders.parameter_vectors + shaders.count_vectors) * 16)
        , shading((7 + 2 * scene.lights.size()) * sizeof(glm::vec4)) {
        if (!shaders.beams.empty()) {
            beams.emplace(shaders, scene, plan, texels_for_lists(), beam_unit());
        }
        if (shaders.light_beams != 0) {
            light_beams.emplace(*beams, shaders, int(scene.lights.size()), options.width,
                                options.height, texels_for_lists());
        }
        const int listed =
            (beams ? beams->listed() : 0) + (light_beams ? light_beams->listed() : 0);
        for (const auto& storage : shaders.arrays) {
            arrays.emplace_back(storage, storage.has_lists ? listed : 0);
        }
        if (one_draw) {
            whole.emplace(shaders, result);
        } else {
            make_passes();
        }
        if (!shaders.surface.empty()) {
            secondary.emplace(shaders, plan.tile_width, plan.tile_height,
                              unit_arrays + int(shaders.arrays.size()));
            secondary->connect(passes->shade);
        }
        if (scene.environment) load_environment();
        if (!shaders.motion.empty()) {
            moved.emplace(shaders, plan);
        }
        if (!shaders.proof.empty()) {
            proofs.emplace(
                shaders, scene, plan, beam_unit() + BeamPass::units,
                whole ? &whole->gate() : nullptr,
                Proofs::Again{options.proofs_in_doubles && context.info().has(4, 0),
                              [this](const gpu::Program& program) { connect(program); }});
        }
        for_each_program([&](const gpu::Program& program) { connect(program); });
    }

    // Lists are texels of a buffer that beams write and read as a storage block. Elements are told
    // by floats, too.
    int texels_for_lists() const {
        const gpu::ContextInfo& info = context.info();
        return std::min({info.max_texture_buffer_size,
                         info.max_storage_block_size / int(sizeof(glm::vec4)), 1 << 24});
    }

    // Of the shade pass's attachments.
    std::vector<gpu::Format> formats() const {
        std::vector<gpu::Format> all(2 + shaders.attachments.size(), gpu::Format::rgba32f);
        all[1] = record.format();
        for (std::size_t k = 0; k < shaders.attachments.size(); ++k) {
            if (shaders.attachments[k] == synthesis::Channel::ending)
                all[2 + k] = gpu::Format::r32f;
        }
        return all;
    }

    void make_passes() {
        passes = Passes{ray_program(shaders, shaders.march, "march"),
                        gpu::Program(shaders.vertex, shaders.active, "active"),
                        gpu::Program(shaders.shade_vertex, shaders.shade, "shade"),
                        RayTargets(plan.tile_width, plan.tile_height, shaders.state_textures)};
    }

    void load_environment() {
        const image::EnvironmentMap map = image::read_environment(scene.environment->map);
        if (map.mended > 0 && options.warn) {
            options.warn(image::mending(scene.environment->map, map.mended));
        }
        environment.emplace(gpu::Format::rgba32f, map.width, map.height, map.texels);
        environment_print =
            base::Fingerprint().add_values(std::span<const float>(map.texels)).text();
        const int unit = unit_arrays + int(shaders.arrays.size()) + SecondaryRays::units;
        passes->shade.bind_sampler("environment_map", unit);
        environment->bind(unit);
    }

    void for_each_program(const std::function<void(const gpu::Program&)>& visit) const {
        if (whole) whole->for_each_program(visit);
        if (passes) {
            for (const gpu::Program* program : {&passes->march, &passes->active, &passes->shade}) {
                visit(*program);
            }
        }
        if (secondary) secondary->for_each_program(visit);
        if (moved) visit(moved->program());
        if (proofs) proofs->for_each_program(visit);
        if (beams) beams->for_each_program(visit);
    }

    void connect(const gpu::Program& program) const {
        program.bind_block("Frame", binding_frame);
        program.bind_block("Parameters", binding_parameters);
        program.bind_block("Shading", binding_shading);
        program.bind_sampler("state_texture_0", unit_state_0);
        program.bind_sampler("state_texture_1", unit_state_1);
        program.bind_sampler("state_texture_2", unit_state_2);
        program.bind_sampler("beam_texture", beam_unit());
        program.bind_sampler("beam_lists_texture", beam_unit() + 1);
        program.bind_sampler("beam_all_texture", beam_unit() + 2);
        if (light_beams) light_beams->connect(program, light_unit());
        for (std::size_t a = 0; a < shaders.arrays.size(); ++a) {
            const auto& storage = shaders.arrays[a];
            if (storage.kind == synthesis::ArrayStorage::Kind::uniform_block) {
                program.bind_block(storage.name + "_block", binding_arrays + unsigned(a));
            } else {
                program.bind_sampler(storage.name, unit_arrays + int(a));
            }
        }
    }

    FrameBlock frame_block_of(const scene::SceneAt& now, const scene::Aim& aim) {
        const bool by_cubics = scene.isolation.method == scene::Method::hermite;
        return by_cubics ? frame_block(scene, now, options.width, options.height, aim,
                                       element_radius.least(scene, now))
                         : frame_block(scene, now, options.width, options.height, aim);
    }

    void upload(const scene::SceneAt& now, const scene::Aim& aim) {
        const FrameBlock block = frame_block_of(now, aim);
        frame.update(std::as_bytes(std::span(&block, 1)));
        upload_field(now);
        const auto shades = shading_block(scene, now, options.width, options.height);
        shading.update(std::as_bytes(std::span(shades)));
        background = shades[1];
        done = 0;
        for_each_program([&](const gpu::Program& program) { set_effects(program, now); });
        if (environment) {
            environment->bind(unit_arrays + int(shaders.arrays.size()) + SecondaryRays::units);
        }
        if (light_beams) draw_light_beams(now);
        if (beams) beams->upload(now, options.width, options.height, aim);
        if (proofs) proofs->upload(scene, now, options.width, options.height, aim);
        frame.bind(binding_frame);
        shading.bind(binding_shading);
    }

    void draw_light_beams(const scene::SceneAt& now) {
        light_beams->draw(scene, now, binding_frame,
                          synthesis::has_lists(shaders) ? &arrays[0] : nullptr);
        light_beams->bind(light_unit());
        light_beams->set_views(secondary->shadows());
    }

    void set_effects(const gpu::Program& program, const scene::SceneAt& now) const {
        for (const auto& [name, value] : effect_uniforms(scene, now)) {
            std::visit([&, &name = name](const auto& v) { program.set(name, v); }, value);
        }
    }

    void upload_field(const scene::SceneAt& at) {
        parameters.update(parameter_block(shaders, at));
        parameters.bind(binding_parameters);
        for (std::size_t a = 0; a < arrays.size(); ++a) {
            arrays[a].update(array_texels(scene, shaders, at, a));
            arrays[a].bind(binding_arrays + unsigned(a), unit_arrays + int(a));
        }
    }

    // Marches the rays of a tile to their ends; returns the target that holds them.
    const gpu::Target& march_rays(const gpu::Rectangle& tile, const gpu::Program& program,
                                  const RayTargets& targets, int& draws) {
        const gpu::Rectangle viewport{0, 0, tile.width, tile.height};
        program.set("tile_origin", glm::ivec2(tile.x, tile.y));
        program.set("evaluations_per_pass", evaluations_of(program));
        program.set("element_budget", plans.element_budget);
        const gpu::Target *from = &targets.odd, *to = &targets.even;
        for (bool first = true;; first = false) {
            from->texture(0).bind(unit_state_0);
            from->texture(1).bind(unit_state_1);
            if (shaders.state_textures > 2) from->texture(2).bind(unit_state_2);
            program.set("first_pass", first ? 1 : 0);
            run_ray_pass(shaders.stage, program, *to, tile.width, tile.height, triangle);
            ++draws;

            to->texture(0).bind(unit_state_0);
            to->texture(1).bind(unit_state_1);
            result.bind();
            gpu::set_viewport(viewport);
            passes->active.use();
            still_active.begin();
            triangle.draw();
            still_active.end();
            if (still_active.passed() == 0) return *to;
            stop_if_asked();
            std::swap(from, to);
        }
    }

    void stop_if_asked() const {
        if (options.progress) options.progress(done);
        if (options.stop && options.stop()) throw Stopped{};
    }

    // Mirrored rays go by no lists.
    int evaluations_of(const gpu::Program& program) const {
        const bool by_lists =
            &program == &passes->march || (light_beams && &program == &secondary->shadows());
        const bool is_planned = !synthesis::has_lists(shaders) || by_lists;
        const int all = is_planned ? plan.evaluations_per_pass : plans.evaluations_without_lists;
        if (shaders.shadow.empty() || &program != &secondary->shadows()) return all;
        // One light after the other, neighbours wait for the longest ray of each.
        const auto lights = std::popcount(unsigned(synthesis::shadow_mask(scene)));
        return std::max(all / lights, shaders.degree + 1);
    }

    int beam_unit() const {
        return unit_arrays + int(shaders.arrays.size()) + SecondaryRays::units + 1;
    }
    int light_unit() const { return beam_unit() + BeamPass::units + Proofs::units; }

    static void add(const Tally& tally, Picture& picture) {
        for (std::size_t k = 0; k < 5; ++k) picture.verdicts[k] += tally.verdicts[k];
        picture.evaluations += tally.evaluations;
    }

    void draw_beams(const gpu::Rectangle& tile) const {
        if (keeps_beams) return beams->bind(beam_unit());
        if (!beams) return;
        beams->draw({0, 0, tile.width, tile.height}, {tile.x, tile.y},
                    synthesis::has_lists(shaders) ? &arrays[0] : nullptr);
    }

    // Draws a tile into `result`, reads its record and adds that to the picture's.
    // Returns its rays, or null if they were not kept.
    const gpu::Target* draw_tile(const gpu::Rectangle& tile, const scene::SceneAt& now,
                                 Picture& picture) {
        draw_beams(tile);
        if (one_draw) {
            whole->draw(tile, plan.evaluations_per_pass, plans.element_budget, background);
            ++picture.passes;
            record.read(result, 1, tile.width, tile.height);
            const Tally tally = record.tally();
            if (tally.rays() == std::int64_t(tile.width) * tile.height) {
                add(tally, picture);
                return nullptr;
            }
            // Some ray takes longer than a draw may; others of this scene will too.
            one_draw = false;
            make_passes();
            picture.compiled = true;
            for (const gpu::Program* program : {&passes->march, &passes->active, &passes->shade}) {
                connect(*program);
                set_effects(*program, now);
            }
        }
        const gpu::Target& rays = draw_in_passes(tile, picture.passes);
        record.read(result, 1, tile.width, tile.height);
        add(record.tally(), picture);
        return &rays;
    }

    // The rays of a tile, which it returns, and what starts where they end.
    const gpu::Target& draw_in_passes(const gpu::Rectangle& tile, int& draws) {
        const gpu::Target& rays = march_rays(tile, passes->march, passes->rays, draws);
        if (secondary) {
            secondary->trace(
                tile, rays,
                [&](const gpu::Program& program, const RayTargets& targets) -> const gpu::Target& {
                    return march_rays(tile, program, targets, draws);
                });
        }
        shade_tile(tile, rays);
        return rays;
    }

    void shade_tile(const gpu::Rectangle& tile, const gpu::Target& rays) {
        rays.texture(0).bind(unit_state_0);
        rays.texture(1).bind(unit_state_1);
        result.bind();
        gpu::set_viewport({0, 0, tile.width, tile.height});
        passes->shade.set("tile_origin", glm::ivec2(tile.x, tile.y));
        passes->shade.use();
        triangle.draw();
    }

    // The channel velocity of a tile whose rays and record are there.
    void draw_velocity(const gpu::Rectangle& tile, const gpu::Target& rays,
                       const scene::SceneAt& now, const Motion& motion, image::Frame& drawn) {
        rays.texture(0).bind(unit_state_0);
        rays.texture(1).bind(unit_state_1);
        const auto field_at = [&](const scene::SceneAt& other) {
            upload_field(other);
            return moved->field_there(tile, now.placement, other.placement);
        };
        const std::vector<float> before = field_at(motion.before), after = field_at(motion.after);
        upload_field(now);
        const std::vector<glm::dvec3> found =
            velocities(motion, now, options.width, options.height, tile, record,
                       rays.read(0, 0, 0, tile.width, tile.height), before, after);
        int k = 0;
        for (image::Channel* channel : Layers::of(drawn, synthesis::Channel::velocity)) {
            planes.fill(tile, *channel, [&](std::size_t at) { return float(found[at][k]); });
            ++k;
        }
    }

    // Proves the rays of a tile that is drawn; counts and, where wanted, keeps the outcomes.
    void prove_tile(const gpu::Rectangle& tile, Picture& picture) {
        const auto count = std::size_t(tile.width) * std::size_t(tile.height) * 4;
        proved.resize(count);
        proofs->prove(result, one_draw, tile, binding_frame, proved);
        frame.bind(binding_frame);
        for (std::size_t k = 0; k < count; k += 4) ++picture.proofs[std::size_t(proved[k])];
        if (layers.wants(synthesis::Channel::proof)) {
            planes.copy(proved.data(), tile, 0, tile.height,
                        Layers::of(picture.frame, synthesis::Channel::proof));
        }
    }

    Picture draw(const scene::SceneAt& now, const scene::Aim& aim, const Motion* motion) {
        Picture picture;
        picture.frame = layers.blank(options.width, options.height, std::move(used));
        upload(now, aim);
        const double pixels = double(options.width) * options.height;
        for (int y = 0; y < options.height; y += plan.tile_height) {
            for (int x = 0; x < options.width; x += plan.tile_width) {
                stop_if_asked();
                const gpu::Rectangle tile{x, y, std::min(plan.tile_width, options.width - x),
                                          std::min(plan.tile_height, options.height - y)};
                const gpu::Target* rays = draw_tile(tile, now, picture);
                fill_counts(tile, picture.frame);
                if (proofs) prove_tile(tile, picture);
                if (moved && motion) draw_velocity(tile, *rays, now, *motion, picture.frame);
                layers.for_each_attachment(picture.frame, [&](int k, const auto& channels) {
                    planes.read(result, k, tile, channels);
                });
                done += double(tile.width) * tile.height / pixels;
            }
        }
        return picture;
    }

    // What is told of each ray, of the tile whose record is there.
    void fill_counts(const gpu::Rectangle& tile, image::Frame& of) const {
        const auto fill = [&](synthesis::Channel kind, const auto& number) {
            if (image::Channel* channel = Layers::of(of, kind)[0]) {
                planes.fill(tile, *channel, [&](std::size_t k) { return float(number(k)); });
            }
        };
        fill(synthesis::Channel::verdict, [&](std::size_t k) { return record.verdict(k); });
        fill(synthesis::Channel::evaluations, [&](std::size_t k) { return record.evaluations(k); });
    }

    // ----- pictures on their way

    // Of one tile, drawn at once: for others the program has to look between their draws.
    bool overlaps() const {
        return options.overlap && one_draw && !proofs && options.width <= plan.tile_width &&
               options.height <= plan.tile_height;
    }

    // A picture that was asked for: what it is of, its pixels to come, or itself.
    struct Flight {
        scene::SceneAt now;
        scene::Aim aim;
        std::optional<gpu::Transfer> pixels;
        std::optional<Picture> picture;
        std::chrono::duration<double> begun; // the time that asking took
    };

    void expect_in_flight(int most) const {
        if (int(flights.size()) <= most) return;
        throw std::logic_error(
            fmt::format("{} pictures that were asked for are not taken yet", flights.size()));
    }

    template<class Action> void none_left_on_failure(const Action& action) {
        try {
            action();
        } catch (...) {
            flights.clear();
            throw;
        }
    }

    void launch(const scene::SceneAt& now, const scene::Aim& aim) {
        upload(now, aim);
        stop_if_asked();
        const gpu::Rectangle tile{0, 0, options.width, options.height};
        draw_beams(tile);
        whole->draw(tile, plan.evaluations_per_pass, plans.element_budget, background);
        if (transfers.empty()) transfers.emplace_back(bytes_of_a_tile());
        gpu::Transfer pixels = std::move(transfers.back());
        transfers.pop_back();
        std::size_t end = 0;
        for (int k = 0; k < result.attachments(); ++k) end = pixels.ask(result, k, tile, end);
        pixels.send();
        flights.push_back({now, aim, std::move(pixels), {}, {}});
    }

    std::size_t bytes_of_a_tile() const {
        std::size_t bytes = 0;
        for (int k = 0; k < result.attachments(); ++k) bytes += result.bytes_in(k, result.area());
        return bytes;
    }

    // The picture that was asked for first.
    Picture land() {
        Flight flight = std::move(flights.front());
        flights.pop_front();
        if (!flight.picture) {
            flight.picture = read(*flight.pixels);
            transfers.push_back(std::move(*flight.pixels));
        }
        // Some ray takes longer than a draw may.
        if (!flight.picture) flight.picture = draw(flight.now, flight.aim, nullptr);
        flight.picture->drawing = flight.begun;
        return std::move(*flight.picture);
    }

    // None if not all rays have ended.
    std::optional<Picture> read(gpu::Transfer& pixels) {
        const gpu::Rectangle tile{0, 0, options.width, options.height};
        Picture picture;
        picture.passes = 1;
        bool ended = false;
        pixels.read([&](std::span<const std::byte> bytes) {
            std::vector<const std::byte*> begin; // of each attachment, as launch() asked for them
            for (int k = 0; k < result.attachments(); ++k) {
                begin.push_back(bytes.data());
                bytes = bytes.subspan(result.bytes_in(k, tile));
            }
            record.take({reinterpret_cast<const std::uint32_t*>(begin[1]),
                         result.bytes_in(1, tile) / sizeof(std::uint32_t)},
                        tile.width, tile.height);
            const Tally tally = record.tally();
            ended = tally.rays() == std::int64_t(tile.width) * tile.height;
            if (!ended) return;
            add(tally, picture);
            picture.frame = layers.blank(options.width, options.height, std::move(used));
            layers.for_each_attachment(picture.frame, [&](int k, const auto& channels) {
                planes.copy(reinterpret_cast<const float*>(begin[std::size_t(k)]), tile, 0,
                            tile.height, channels);
            });
        });
        if (!ended) return std::nullopt;
        fill_counts(tile, picture.frame);
        return picture;
    }

    gpu::Context& context;
    scene::Scene scene;
    RenderOptions options;
    synthesis::Shaders shaders;
    ScenePlan plans;
    const MarchPlan& plan;          // the march's
    bool one_draw;                  // as long as every tile's rays ended in one
    std::optional<WholeDraw> whole; // into `result`
    struct Passes {
        gpu::Program march, active, shade;
        RayTargets rays;
    };
    std::optional<Passes> passes;
    Record record; // of the tile drawn last
    Planes planes;
    Layers layers;
    gpu::Target result;
    gpu::UniformBuffer frame, parameters, shading;
    ElementRadius element_radius;
    std::vector<ArrayBuffer> arrays;
    std::optional<SecondaryRays> secondary;
    std::optional<gpu::Texture> environment;
    std::string environment_print; // of its texels
    glm::vec4 background{0};       // of the picture being drawn
    double done = 0;               // the part of it that is drawn
    std::string shaders_print = synthesis::fingerprint(shaders);
    std::optional<VelocityPass> moved; // of the channel velocity
    std::optional<BeamPass> beams;
    bool keeps_beams = false;
    std::optional<LightBeams> light_beams;
    std::optional<Proofs> proofs; // of scenes that ask for them
    std::vector<float> proved;    // of the tile proved last
    gpu::Fullscreen triangle;
    gpu::SamplesQuery still_active;
    image::Frame used; // whose memory the next picture may have
    std::deque<Flight> flights;
    std::vector<gpu::Transfer> transfers; // that no picture is in
};

Renderer::Renderer(gpu::Context& context, const scene::Scene& scene, RenderOptions options)
    : parts_(
          (context.make_current(), std::make_unique<Parts>(context, scene, std::move(options)))) {}

Renderer::~Renderer() = default;

const MarchPlan& Renderer::plan() const { return parts_->plan; }

void Renderer::reuse(Picture picture) { parts_->used = std::move(picture.frame); }

void Renderer::resize(int width, int height) {
    Parts& p = *parts_;
    // Beams' blocks lie in tiles: tiles that begin elsewhere would cut other blocks.
    const auto cuts = [](int tile, int side) {
        return side > tile && tile % synthesis::beam_square != 0;
    };
    if (width < 1 || height < 1 || cuts(p.plan.tile_width, width) ||
        cuts(p.plan.tile_height, height)) {
        throw std::invalid_argument(fmt::format(
            "a picture of {} x {} cannot be drawn with tiles of {} x {}: make the renderer for "
            "multiples of {}",
            width, height, p.plan.tile_width, p.plan.tile_height, synthesis::beam_square));
    }
    p.expect_in_flight(0);
    p.options.width = width;
    p.options.height = height;
    p.planes = Planes(width, height);
    if (p.light_beams) p.light_beams->resize(width, height);
}

void Renderer::adjust(const scene::Isolation& settings) {
    scene::Isolation& current = parts_->scene.isolation;
    if (settings.method != current.method || settings.beam != current.beam ||
        settings.certify != current.certify) {
        throw std::invalid_argument("other shaders are another renderer's");
    }
    current = settings;
}

bool Renderer::needs_motion() const { return parts_->moved.has_value(); }

void Renderer::keep_beams(bool keep) {
    const Parts& p = *parts_;
    if (p.plan.tile_width < p.options.width || p.plan.tile_height < p.options.height) {
        throw std::logic_error("beams are kept of one tile, and the picture has several");
    }
    parts_->keeps_beams = keep;
}

Picture Renderer::draw(const scene::SceneAt& now, const scene::Aim& aim, const Motion* motion) {
    Parts& p = *parts_;
    p.expect_in_flight(0);
    const auto begin = std::chrono::steady_clock::now();
    p.context.make_current();
    Picture picture = p.draw(now, aim, motion);
    picture.drawing = std::chrono::steady_clock::now() - begin;
    return picture;
}

int Renderer::in_flight() const { return int(parts_->flights.size()); }

int Renderer::most_in_flight() const { return parts_->overlaps() ? 2 : 1; }

void Renderer::start(const scene::SceneAt& now, const scene::Aim& aim, const Motion* motion) {
    Parts& p = *parts_;
    if (in_flight() >= most_in_flight()) p.expect_in_flight(most_in_flight() - 1);
    const auto begin = std::chrono::steady_clock::now();
    p.context.make_current();
    p.none_left_on_failure([&] {
        if (p.overlaps() && !motion) {
            p.launch(now, aim);
        } else {
            p.flights.push_back({{}, {}, {}, p.draw(now, aim, motion), {}});
        }
    });
    p.flights.back().begun = std::chrono::steady_clock::now() - begin;
}

Picture Renderer::take() {
    Parts& p = *parts_;
    if (p.flights.empty()) throw std::logic_error("no picture was asked for");
    const auto begin = std::chrono::steady_clock::now();
    p.context.make_current();
    Picture picture;
    p.none_left_on_failure([&] { picture = p.land(); });
    picture.drawing += std::chrono::steady_clock::now() - begin;
    return picture;
}

std::string Renderer::fingerprint(const scene::SceneAt& now, const scene::Aim& aim,
                                  const Motion* motion) const {
    Parts& p = *parts_;
    base::Fingerprint print;
    const synthesis::Shaders& shaders = p.shaders;
    print.add(p.shaders_print);
    const auto add_field = [&](const scene::SceneAt& at) {
        const FrameBlock block = p.frame_block_of(at, aim);
        print.add_values(std::span<const FrameBlock>(&block, 1));
        print.add(parameter_block(shaders, at));
        for (std::size_t a = 0; a < shaders.arrays.size(); ++a) {
            const auto texels = array_texels(p.scene, shaders, at, a);
            print.add_values(std::span<const glm::vec4>(texels));
        }
    };
    add_field(now);
    const auto shades = shading_block(p.scene, now, p.options.width, p.options.height);
    print.add_values(std::span<const glm::vec4>(shades));
    for (const auto& [name, value] : effect_uniforms(p.scene, now)) {
        print.add(name);
        std::visit([&](const auto& v) { print.add_values(std::span(&v, 1)); }, value);
    }
    print.add(p.environment_print);
    if (motion) {
        add_field(motion->before);
        add_field(motion->after);
    }
    const std::array size{p.options.width, p.options.height};
    print.add_values(std::span<const int>(size));
    for (const auto wanted : p.options.channels) print.add(std::to_string(int(wanted)));
    return print.text();
}

const std::string& Renderer::shaders_fingerprint() const { return parts_->shaders_print; }

} // namespace isomotion::render
