#include "render/renderer.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "gpu/target.h"
#include "gpu/texture.h"
#include "image/environment.h"
#include "image/environment_levels.h"
#include "render/frame_pictures.h"
#include "render/fused_pass.h"
#include "render/fused_surfaces.h"
#include "render/layers.h"
#include "render/picture_proofs.h"
#include "render/pictures_in_flight.h"
#include "render/planes.h"
#include "render/ray_clock.h"
#include "render/read_back.h"
#include "render/several_surfaces.h"
#include "render/single_surface.h"
#include "render/surface_passes.h"
#include "render/velocity_pass.h"
#include "scene/surfaces.h"
#include "shader/effect_text.h"

namespace isomotion::render {
namespace {

using shader::Channel, shader::Role;

// The formats of the shade pass's attachments.
std::vector<gpu::Format> formats(const shader::Passes& passes, const Record& record,
                                 bool over_each_other) {
    std::vector<gpu::Format> all(2 + passes.attachments.size(), gpu::Format::rgba32f);
    all[1] = record.format();
    for (std::size_t k = 0; k < passes.attachments.size(); ++k) {
        if (passes.attachments[k] == Channel::ending) all[2 + k] = gpu::Format::r32f;
    }
    if (over_each_other) all.push_back(way_format);
    return all;
}

void add(const Tally& tally, const gpu::Rectangle& tile, int height, Picture& picture) {
    for (std::size_t k = 0; k < 5; ++k) picture.verdicts[k] += tally.verdicts[k];
    add(in_picture(tally.rays, tile, height), picture.rays);
}

} // namespace

struct Renderer::Parts {
    Parts(gpu::Context& made_in, const scene::Scene& drawn, RenderOptions wanted)
        : context(made_in)
        , options(std::move(wanted))
        , scene(drawn)
        , surfaces(surfaces_of_scene())
        , first(*surfaces.front())
        , passes(first.passes)
        , plan(first.plan)
        , table(first.table)
        , passes_print(fingerprint_of_passes())
        , record(plan.march.target_width() * plan.march.target_height(),
                 passes.has(Role::surface) && !passes.has(Role::fused))
        , planes(options.width, options.height)
        // A software renderer draws the next picture with all processors meanwhile.
        , back(context.info().software ? 1 : options.threads)
        , layers(options.channels, passes.attachments)
        , result(plan.march.target_width(), plan.march.target_height(),
                 formats(passes, record, draws_over_each_other())) {
        if (draws_over_each_other()) {
            one_draw = std::make_unique<FusedSurfaces>(all_surfaces(), result,
                                                       formats(passes, record, true));
        } else if (passes.has(Role::fused)) {
            one_draw = std::make_unique<FusedPass>(first, result, reads_at_once());
        } else {
            begin_passes();
        }
        if (const auto& environment_of_scene = scene.environment)
            load_environment(*environment_of_scene);
        if (options.times_rays) {
            clock.emplace();
            for (SurfacePasses* surface : all_surfaces()) surface->table.time_rays_by(*clock);
        }
        if (passes.has(Role::motion)) moved.emplace(plan.march);
        if (passes.has(Role::proof)) {
            proofs.emplace(all_surfaces(), options.proofs_in_doubles && context.info().has(4, 0));
        }
    }

    // Whether each of several surfaces is drawn in one draw.
    bool draws_over_each_other() const { return surfaces.size() > 1 && passes.has(Role::fused); }

    std::vector<SurfacePasses*> all_surfaces() const {
        std::vector<SurfacePasses*> all;
        for (const auto& surface : surfaces) all.push_back(surface.get());
        return all;
    }

    void load_environment(const scene::Environment& from) {
        base::Fingerprint print;
        image::EnvironmentSink sink;
        std::optional<image::EnvironmentReduction> reduction;
        if (shader::mirrors_environment(first.drawn)) reduction.emplace(image::widest_reduction);
        sink.begin = [&](int width, int height) {
            environment.emplace(gpu::Format::rgba32f, width, height);
            if (reduction) reduction->begin(width, height);
            print.begin(4 * sizeof(float) * std::size_t(width) * std::size_t(height));
        };
        sink.rows = [&](int first, std::span<const float> texels) {
            environment->update_rows(first, texels);
            if (reduction) reduction->rows(first, texels);
            print.append(std::as_bytes(texels));
        };
        const int mended = image::read_environment(from.map, sink, from.within, from.stated_at);
        if (mended > 0 && options.warn) options.warn(image::mending(from.map, mended));
        environment_print = print.text();
        if (!reduction) return;
        const image::EnvironmentMap levels =
            image::environment_levels(reduction->map(), image::widest_level);
        environment_levels.emplace(gpu::Format::rgba32f, levels.width, levels.height,
                                   levels.texels);
    }

    // ----- what a frame is drawn from

    // `fields`: one for each surface.
    PictureInputs prepare(const scene::SceneAt& now, const scene::Aim& aim, const Motion* motion,
                          std::vector<SharedField>& fields) {
        const auto begin = std::chrono::steady_clock::now();
        if (now.surfaces.size() != surfaces.size())
            throw std::logic_error("a time of a scene with other surfaces");
        fields.resize(surfaces.size());
        const int width = options.width, height = options.height;
        PictureInputs inputs;
        inputs.width = width;
        inputs.height = height;
        inputs.aim = aim;
        for (std::size_t k = 0; k < surfaces.size(); ++k) {
            inputs.surfaces.push_back(
                surfaces[k]->prepare(now, aim, motion, width, height, fields[k]));
            if (surfaces.size() == 1) continue;
            for (auto& uniform : uniforms_among(surfaces[k]->drawn, now, width, height, aim))
                inputs.surfaces.back().effects.push_back(std::move(uniform));
        }
        if (motion) inputs.moving = {now, *motion};
        if (proofs && surfaces.size() > 1) see_others(inputs, now, aim);
        inputs.preparing = std::chrono::steady_clock::now() - begin;
        return inputs;
    }

    std::vector<std::unique_ptr<SurfacePasses>> surfaces_of_scene() {
        std::vector<std::unique_ptr<SurfacePasses>> all;
        for (PlannedSurface& planned : plan_surfaces(scene, options, context.info())) {
            all.push_back(std::make_unique<SurfacePasses>(
                std::move(planned), options, context.info(), [this] { stop_if_asked(); }));
        }
        return all;
    }

    std::string fingerprint_of_passes() const {
        std::string prints;
        if (!options.tells_endings) {
            for (const auto& surface : surfaces) prints += surface->passes.fingerprint();
            return prints;
        }
        RenderOptions plain = options;
        plain.tells_endings = false;
        for (const PlannedSurface& planned : plan_surfaces(scene, plain, context.info()))
            prints += planned.passes.fingerprint();
        return prints;
    }

    std::string fingerprint(const std::vector<PictureInputs>& pictures) const {
        base::Fingerprint print;
        print.add(passes_print);
        for (const PictureInputs& picture : pictures) picture.add_to(print);
        print.add(environment_print);
        for (const auto wanted : options.channels) print.add(std::to_string(int(wanted)));
        return print.text();
    }

    // ----- one picture

    void begin_passes() {
        if (surfaces.size() == 1) {
            in_passes = std::make_unique<SingleSurface>(first);
        } else {
            in_passes = std::make_unique<SeveralSurfaces>(all_surfaces());
        }
    }

    void draw_in_passes() {
        if (!one_draw) return;
        one_draw.reset();
        compiles = true;
        begin_passes();
    }

    void choose_draws(const PictureInputs& inputs) {
        for (std::size_t k = 0; k < surfaces.size(); ++k) {
            const auto& grid = inputs.surfaces[k].field->grid;
            if (grid && are_lists_long(*grid, surfaces[k]->plan)) draw_in_passes();
        }
    }

    void upload(const PictureInputs& inputs) {
        done = 0;
        const glm::ivec2 corner = plan.march.corner_of(options.width, options.height);
        for (const auto& surface : surfaces) surface->table.begin_tiles_at(corner);
        for (std::size_t k = 0; k < surfaces.size(); ++k)
            surfaces[k]->upload(inputs.surfaces[k], options.width, options.height);
        if (environment) table.bind("environment_map", *environment);
        if (environment_levels) table.bind("environment_levels", *environment_levels);
    }

    // Inputs must be for pictures of this size.
    void expect_own_size(const PictureInputs& inputs) const {
        if (inputs.width == options.width && inputs.height == options.height) return;
        throw std::logic_error(fmt::format("inputs of {} x {} pixels for a picture of {} x {}",
                                           inputs.width, inputs.height, options.width,
                                           options.height));
    }

    Picture draw(const PictureInputs& inputs) {
        Picture picture;
        picture.frame = layers.blank(options.width, options.height, std::move(used));
        upload(inputs);
        const double pixels = double(options.width) * options.height;
        const int across = plan.march.tile_width, up = plan.march.tile_height;
        for (int y = 0; y < options.height; y += up) {
            for (int x = 0; x < options.width; x += across) {
                stop_if_asked();
                const gpu::Rectangle tile{x, y, std::min(across, options.width - x),
                                          std::min(up, options.height - y)};
                draw_tile(inputs, tile, picture);
                fill_counts(tile, picture.frame);
                if (const auto at = endings_in(inputs)) {
                    const gpu::Rectangle area = table.in_targets(tile);
                    take_endings(inputs, tile,
                                 result.read(*at, area.x, area.y, area.width, area.height).data(),
                                 picture);
                }
                if (proofs) prove_tile(*proofs, inputs, tile, picture);
                if (moved && inputs.moving)
                    draw_velocities(*moved, *inputs.moving, inputs, tile, picture.frame);
                read_attachments(tile, picture.frame);
                done += double(tile.width) * tile.height / pixels;
            }
        }
        if (clock) picture.marching = clock->take();
        picture.compiled = picture.compiled || std::exchange(compiles, false);
        tell_drawn();
        return picture;
    }

    void tell_drawn() const {
        if (options.progress) options.progress(1);
    }

    bool reads_at_once() const { return options.reads_at_once.value_or(!context.info().software); }

    void read_attachments(const gpu::Rectangle& tile, image::Frame& frame) {
        const std::vector<Attachment> attachments = attachments_of(layers, frame);
        if (!reads_at_once())
            return back.in_strips(result, table.corner(), attachments, tile, planes);
        gpu::Transfer pixels = flights.transfer(bytes_of_a_tile());
        back.at_once(result, table.corner(), attachments, tile, planes, pixels);
        flights.give_back(std::move(pixels));
    }

    void stop_if_asked() const {
        if (options.progress) options.progress(done);
        if (options.stop && options.stop()) throw Stopped();
    }

    // Draws a tile into `result` and counts its rays.
    void draw_tile(const PictureInputs& inputs, const gpu::Rectangle& tile, Picture& picture) {
        if (one_draw) {
            one_draw->draw(inputs, tile, picture.passes);
            record.read(result, 1, table.in_targets(tile));
            if (take_ended(tile, picture)) return;
            draw_in_passes(); // some ray takes longer than a draw may
        }
        in_passes->draw(inputs, tile, result, environment ? &*environment : nullptr,
                        picture.passes);
        record.read(result, 1, table.in_targets(tile));
        add(record.tally(), tile, options.height, picture);
    }

    // Adds the record that was read last to the picture's, if all rays of its tile ended.
    bool take_ended(const gpu::Rectangle& tile, Picture& picture) const {
        const Tally tally = record.tally();
        if (tally.ended() != std::int64_t(tile.width) * tile.height) return false;
        add(tally, tile, options.height, picture);
        return true;
    }

    // Takes the endings that the inputs ask for of a tile, given as rows from the bottom.
    void take_endings(const PictureInputs& inputs, const gpu::Rectangle& tile, const float* of_tile,
                      Picture& picture) const {
        for (const int pixel : inputs.endings_of) {
            const int column = pixel % options.width, row = pixel / options.width;
            const int x = column - tile.x, y = options.height - 1 - row - tile.y;
            if (x < 0 || y < 0 || x >= tile.width || y >= tile.height) continue;
            picture.endings.push_back({column, row, of_tile[y * tile.width + x]});
        }
    }

    // The attachment with the endings, if inputs ask for any.
    std::optional<int> endings_in(const PictureInputs& inputs) const {
        if (inputs.endings_of.empty()) return std::nullopt;
        return passes.attachment(Channel::ending);
    }

    // Fills the channels verdict and evaluations of the tile whose record was read last.
    void fill_counts(const gpu::Rectangle& tile, image::Frame& of) const {
        const auto fill = [&](Channel kind, const auto& number) {
            if (image::Channel* channel = Layers::of(of, kind)[0]) {
                planes.fill(tile, *channel, [&](std::size_t k) { return float(number(k)); });
            }
        };
        fill(Channel::verdict, [&](std::size_t k) { return record.verdict(k); });
        fill(Channel::evaluations, [&](std::size_t k) { return record.evaluations(k); });
    }

    // Proves the rays of a tile; counts and, where wanted, keeps the outcomes.
    void prove_tile(PictureProofs& by, const PictureInputs& inputs, const gpu::Rectangle& tile,
                    Picture& picture) {
        const bool keeps = layers.wants(Channel::proof);
        const ProofCounts counts = by.prove(inputs, result, tile, keeps);
        for (std::size_t k = 0; k < counts.size(); ++k) picture.proofs[k] += counts[k];
        if (keeps) {
            planes.copy(by.record().data(), tile, 0, tile.height,
                        Layers::of(picture.frame, Channel::proof));
        }
    }

    // The velocity of one surface in a tile whose rays and record are there.
    std::vector<glm::dvec3> velocity_of(SurfacePasses& surface, const VelocityPass& by,
                                        const SurfaceMotion& motion, const SurfaceInputs& own,
                                        const gpu::Target& rays, const gpu::Rectangle& tile) {
        const auto& around = own.motion;
        if (!around) throw std::logic_error("velocities of a surface without times around");
        surface.table.bind_numbered("state_texture", rays);
        const auto field_at = [&](const FieldInputs& then, const scene::OneSurfaceAt& there) {
            surface.field.upload(surface.table, then);
            return by.field_there(surface.table, tile, motion.now.surface.placement, there);
        };
        const std::vector<float> before = field_at(around->before, motion.before);
        const std::vector<float> after = field_at(around->after, motion.after);
        surface.field.upload(surface.table, *own.field);
        return velocities(motion, options.width, options.height, tile, record,
                          rays.read(0, 0, 0, tile.width, tile.height), before, after);
    }

    // A pixel has the velocity of the surface that is seen there.
    void draw_velocities(const VelocityPass& by, const PictureInputs::Moving& moving,
                         const PictureInputs& inputs, const gpu::Rectangle& tile,
                         image::Frame& drawn) {
        const std::vector<int> seen = in_passes->seen(tile);
        std::vector<glm::dvec3> found(seen.size(), glm::dvec3(0));
        for (std::size_t k = 0; k < surfaces.size(); ++k) {
            surfaces[k]->bind();
            const SurfaceMotion motion(moving.now, moving.about, k);
            const std::vector<glm::dvec3> its =
                velocity_of(*surfaces[k], by, motion, inputs.surfaces[k], in_passes->rays(k), tile);
            for (std::size_t at = 0; at < seen.size(); ++at) {
                if (seen[at] == int(k)) found[at] = its[at];
            }
        }
        int k = 0;
        for (image::Channel* channel : Layers::of(drawn, Channel::velocity)) {
            planes.fill(tile, *channel, [&](std::size_t at) { return float(found[at][k]); });
            ++k;
        }
    }

    // ----- pictures on their way

    // A picture that takes one draw may be asked for before the last one is taken: it comes by way
    // of the driver's pixel buffers, and the next is drawn meanwhile. Software renderers gain
    // and lose nothing by it.
    bool overlaps() const {
        return one_draw && surfaces.size() == 1 && !proofs && !clock &&
               plan.march.holds(options.width, options.height);
    }

    gpu::Rectangle whole() const { return {0, 0, options.width, options.height}; }

    void launch(PictureInputs inputs) {
        upload(inputs);
        stop_if_asked();
        int draws = 0;
        one_draw->draw(inputs, whole(), draws);
        gpu::Transfer pixels = flights.transfer(bytes_of_a_tile());
        std::size_t end = 0;
        for (int k = 0; k < result.attachments(); ++k)
            end = pixels.ask(result, k, table.in_targets(whole()), end);
        pixels.send();
        flights.add({std::move(inputs), std::move(pixels), {}, {}});
    }

    std::size_t bytes_of_a_tile() const {
        std::size_t bytes = 0;
        for (int k = 0; k < result.attachments(); ++k) bytes += result.bytes_in(k, result.area());
        return bytes;
    }

    // Takes the picture that was asked for first.
    Picture land() {
        PictureInFlight flight = flights.take();
        if (auto& pixels = flight.pixels) {
            flight.picture = read(*pixels, flight.inputs);
            flights.give_back(std::move(*pixels));
        }
        if (!flight.picture) {
            draw_in_passes(); // some ray takes longer than a draw may
            flight.picture = draw(flight.inputs);
        } else {
            tell_drawn();
        }
        flight.picture->drawing = flight.begun;
        return std::move(*flight.picture);
    }

    // None if not all rays have ended.
    std::optional<Picture> read(gpu::Transfer& pixels, const PictureInputs& inputs) {
        const gpu::Rectangle tile = whole();
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
            ended = tally.ended() == std::int64_t(tile.width) * tile.height;
            if (!ended) return;
            add(tally, tile, options.height, picture);
            if (const auto at = endings_in(inputs)) {
                take_endings(inputs, tile, reinterpret_cast<const float*>(begin[std::size_t(*at)]),
                             picture);
            }
            picture.frame = layers.blank(options.width, options.height, std::move(used));
            const std::vector<Attachment> attachments = attachments_of(layers, picture.frame);
            std::vector<const float*> texels;
            for (const Attachment& attachment : attachments) {
                const std::byte* of_attachment = begin[std::size_t(attachment.number)];
                texels.push_back(reinterpret_cast<const float*>(of_attachment));
            }
            back.copy(attachments, texels, tile, planes);
        });
        if (!ended) return std::nullopt;
        fill_counts(tile, picture.frame);
        return picture;
    }

    gpu::Context& context;
    RenderOptions options;
    scene::Scene scene;
    std::vector<std::unique_ptr<SurfacePasses>> surfaces;
    SurfacePasses& first; // its target, tiles and channels are those of all
    const shader::Passes& passes;
    const ScenePlan& plan;
    PassTable& table;
    const std::string passes_print; // of those that decide pixels
    Record record;                  // of the tile drawn last
    Planes planes;
    ReadBack back;
    Layers layers;
    std::optional<RayClock> clock;
    gpu::Target result;
    std::unique_ptr<OneDraw> one_draw;   // into `result`, as long as every tile's rays end in it
    std::unique_ptr<InPasses> in_passes; // otherwise
    bool compiles = false;               // the next picture, since the one draw is over
    std::optional<gpu::Texture> environment;
    std::optional<gpu::Texture> environment_levels; // where something mirrors it
    std::string environment_print;                  // of its texels
    std::optional<VelocityPass> moved;
    std::optional<PictureProofs> proofs;
    double done = 0;   // the part of the picture that is drawn
    image::Frame used; // whose memory the next picture may have
    PicturesInFlight flights;
};

Renderer::Renderer(gpu::Context& context, const scene::Scene& scene, RenderOptions options)
    : parts_(
          (context.make_current(), std::make_unique<Parts>(context, scene, std::move(options)))) {}

Renderer::~Renderer() = default;

const MarchPlan& Renderer::plan() const { return parts_->plan.march; }

void Renderer::reuse(Picture picture) { parts_->used = std::move(picture.frame); }

void Renderer::resize(int width, int height) {
    Parts& p = *parts_;
    const MarchPlan& tile = p.plan.march;
    // Beams' blocks lie in tiles: tiles that begin elsewhere would cut other blocks.
    const auto cuts = [](int length, int side) {
        return side > length && length % shader::beam_square != 0;
    };
    if (width < 1 || height < 1 || cuts(tile.tile_width, width) || cuts(tile.tile_height, height)) {
        throw std::invalid_argument(fmt::format(
            "a picture of {} x {} cannot be drawn with tiles of {} x {}: make the renderer for "
            "multiples of {}",
            width, height, tile.tile_width, tile.tile_height, shader::beam_square));
    }
    p.flights.expect_at_most(0);
    p.options.width = width;
    p.options.height = height;
    p.planes = Planes(width, height);
}

void Renderer::adjust(const scene::Isolation& settings) {
    std::vector<scene::Surface>& surfaces = parts_->scene.surfaces;
    const scene::Isolation current = surfaces.front().isolation;
    if (settings.method != current.method || settings.beam != current.beam ||
        settings.certify != current.certify) {
        throw std::invalid_argument("other shaders are another renderer's");
    }
    for (scene::Surface& surface : surfaces)
        surface.isolation = scene::changed_alike(surface.isolation, current, settings);
    surfaces.front().isolation = settings;
}

bool Renderer::needs_motion() const { return parts_->moved.has_value(); }

void Renderer::keep_beams(bool keep) {
    const Parts& p = *parts_;
    if (!p.plan.march.holds(p.options.width, p.options.height)) {
        throw std::logic_error("beams are kept of one tile, and the picture has several");
    }
    for (const auto& surface : parts_->surfaces) surface->keeps_beams = keep && surface->beams;
}

PictureInputs Renderer::prepare(const scene::SceneAt& now, const scene::Aim& aim,
                                const Motion* motion) const {
    std::vector<SharedField> fields;
    return parts_->prepare(now, aim, motion, fields);
}

FrameInputs Renderer::prepare(const scene::Scene& scene, int frame) const {
    FrameInputs inputs;
    std::optional<Motion> motion;
    if (needs_motion()) motion = motion_about(scene, frame);
    std::vector<SharedField> fields;
    for_each_picture(scene, frame, [&](const auto& now, const scene::Aim& aim) {
        const bool is_first = inputs.pictures.empty();
        if (is_first) inputs.now = now;
        inputs.pictures.push_back(
            parts_->prepare(now, aim, motion && is_first ? &*motion : nullptr, fields));
    });
    inputs.fingerprint = parts_->fingerprint(inputs.pictures);
    return inputs;
}

Picture Renderer::draw(const PictureInputs& inputs) {
    Parts& p = *parts_;
    p.flights.expect_at_most(0);
    const auto begin = std::chrono::steady_clock::now();
    p.context.make_current();
    p.expect_own_size(inputs);
    p.choose_draws(inputs);
    Picture picture = p.draw(inputs);
    p.context.has_drawn();
    picture.drawing = inputs.preparing + (std::chrono::steady_clock::now() - begin);
    return picture;
}

int Renderer::in_flight() const { return parts_->flights.count(); }

int Renderer::most_in_flight() const { return parts_->overlaps() ? 2 : 1; }

void Renderer::start(PictureInputs inputs) {
    Parts& p = *parts_;
    p.flights.expect_at_most(most_in_flight() - 1);
    const auto begin = std::chrono::steady_clock::now();
    const std::chrono::duration<double> preparing = inputs.preparing;
    p.context.make_current();
    p.flights.guard([&] {
        p.expect_own_size(inputs);
        p.choose_draws(inputs);
        if (p.overlaps() && !inputs.moving) {
            p.launch(std::move(inputs));
        } else {
            Picture picture = p.draw(inputs);
            p.flights.add({std::move(inputs), {}, std::move(picture), {}});
        }
    });
    p.flights.last().begun = preparing + (std::chrono::steady_clock::now() - begin);
}

Picture Renderer::take() {
    Parts& p = *parts_;
    if (p.flights.count() == 0) throw std::logic_error("no picture was asked for");
    const auto begin = std::chrono::steady_clock::now();
    p.context.make_current();
    Picture picture;
    p.flights.guard([&] { picture = p.land(); });
    p.context.has_drawn();
    picture.drawing += std::chrono::steady_clock::now() - begin;
    return picture;
}

const std::string& Renderer::shaders_fingerprint() const { return parts_->passes_print; }

} // namespace isomotion::render
