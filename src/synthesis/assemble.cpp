#include "synthesis/assemble.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/fingerprint.h"
#include "formula/linear_sum.h"
#include "scene/method_domain.h"
#include "synthesis/beam_text.h"
#include "synthesis/bernstein_text.h"
#include "synthesis/effect_text.h"
#include "synthesis/paint_text.h"
#include "synthesis/proof_text.h"
#include "synthesis/shader_files.h"

namespace isomotion::synthesis {
namespace {

// Bounds of Chebyshev polynomials and of waves cost more than the samples they save.
bool bounds_pay(const formula::Field& field) {
    for (std::size_t id = 0; id < field.graph.size(); ++id) {
        switch (field.graph[formula::NodeId(id)].op) {
        case formula::Op::chebyshev:
        case formula::Op::sin:
        case formula::Op::cos:
        case formula::Op::tan:
        case formula::Op::asin:
        case formula::Op::acos:
            return false;
        default:
            break;
        }
    }
    return true;
}

FieldStorage storage_of(const scene::Scene& scene, bool writes_buffers) {
    std::vector<int> counts;
    for (const auto& array : scene.timeline.animation.arrays()) counts.push_back(array.count);
    // With more elements the loops of a beam's shader might end too soon (beam_text.cpp).
    constexpr int fewest = 9, most = 15'000;
    const bool lists = writes_buffers && uses_beams(scene) && !counts.empty() &&
                       counts[0] >= fewest && counts[0] <= most &&
                       formula::linear_sum(*scene.surface.field).has_value();
    return field_storage(*scene.surface.field, scene.surface.parameters, counts, lists);
}

enum class Origin { eye, mirror };

bool contains(const std::vector<Channel>& channels, Channel channel) {
    return std::find(channels.begin(), channels.end(), channel) != channels.end();
}

void add_ray(ShaderText& text, const scene::Scene& scene, Origin origin = Origin::eye) {
    const bool box = scene.surface.bounds.shape == scene::Bounds::Shape::box;
    text.file_of_stage("frame.glsl", "stage/frame.glsl");
    text.file("march/verdict.glsl");
    text.file(box ? "march/clip_box.glsl" : "march/clip_sphere.glsl");
    if (origin == Origin::eye) {
        text.file("march/ray.glsl");
    } else {
        text.generated("the eye's ray by another name", "#define pixel_ray eye_ray\n");
        text.file("march/ray.glsl");
        text.generated("and the mirrored one by its", "#undef pixel_ray\n");
        text.file("effects/surface_point.glsl");
        text.file("effects/load_surface.glsl");
        text.file("effects/mirror_ray.glsl");
    }
    text.file("march/state.glsl");
}

void add_isolation(ShaderText& text, const scene::Scene& scene, const Shaders& shaders) {
    const scene::Method method = scene.isolation.method;
    if (scene::bounds_pieces(method)) return text.file("march/piece_bounds.glsl");
    const bool along = shaders.samples.front() == FieldFunction::along;
    text.file(along ? "march/sample_along.glsl" : "march/sample_value.glsl");
    if (method == scene::Method::hermite || method == scene::Method::chebyshev) return;
    text.file(method == scene::Method::marching ? "march/uniform_step.glsl"
                                                : "march/adaptive_step.glsl");
    text.file(method == scene::Method::amp_taylor ? "march/taylor_test.glsl"
                                                  : "march/sign_test.glsl");
}

// turn(), which takes a ray on by what one sample of the field tells.
void add_turn(ShaderText& text, const scene::Scene& scene, const Shaders& shaders) {
    const scene::Method method = scene.isolation.method;
    if (scene::bounds_pieces(method)) {
        text.file("march/close_in.glsl");
        text.file("march/" + std::string(name(method)) + ".glsl");
        text.file("march/turn_piece.glsl");
        return;
    }
    if (method == scene::Method::chebyshev) {
        text.generated("generated: from samples to Bernstein's form",
                       bernstein_text(shaders.degree));
        text.file("march/bernstein.glsl");
        text.file("march/chebyshev.glsl");
    } else {
        text.file(method == scene::Method::hermite ? "march/hermite.glsl" : "march/amp.glsl");
    }
    text.file("march/turn_point.glsl");
}

std::vector<FieldFunction> samples_of(scene::Method method, bool march_takes_gradient) {
    if (scene::bounds_pieces(method)) return {FieldFunction::value, FieldFunction::along_interval};
    const bool value_alone =
        method == scene::Method::marching || method == scene::Method::chebyshev;
    return {value_alone && !march_takes_gradient ? FieldFunction::value : FieldFunction::along};
}

// What else a ray keeps, for each shader that samples along it.
void define_state(ShaderText& text, const Shaders& shaders) {
    if (shaders.state_textures == 3) text.define("THREE_SAMPLES", 1);
    if (shaders.degree > 0) text.define("DEGREE", shaders.degree);
}

void add_march(ShaderText& text, const scene::Scene& scene, const Shaders& shaders, Origin origin) {
    const bool beam = uses_beams(scene) && origin == Origin::eye;
    if (beam && has_lists(shaders)) text.define("LISTS", 1);
    add_entrance(text, shaders, beam);
    add_isolation(text, scene, shaders);
    text.file(shaders.march_takes_gradient ? "march/gradient_at_root.glsl"
                                           : "march/end_at_root.glsl");
    add_turn(text, scene, shaders);
    text.file("march/march.glsl");
}

// So long that compiling it shows: some 0.2 s on a software renderer, and growing with its length.
bool is_long(const formula::Program& gradient) { return gradient.instructions.size() > 1000; }

std::string march_text(const scene::Scene& scene, Shaders& shaders, Origin origin) {
    ShaderText text(shaders.files, shaders.stage);
    define_state(text, shaders);
    add_field(text, *scene.surface.field, shaders, shaders.samples);
    add_ray(text, scene, origin);
    add_march(text, scene, shaders, origin);
    text.file_of_stage("march/store_state.glsl", "stage/store_state.glsl");
    text.file("march/march_pixel.glsl");
    text.file_of_stage("stage/march.frag", "stage/march.comp");
    return text.take();
}

std::string surface_text(const scene::Scene& scene, Shaders& shaders, Origin origin) {
    ShaderText text(shaders.files);
    std::vector<FieldFunction> functions{FieldFunction::value};
    if (!shaders.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    add_field(text, *scene.surface.field, shaders, functions);
    add_ray(text, scene, origin);
    const bool by_lists = origin == Origin::eye && has_lists(shaders);
    if (by_lists) {
        text.define("LISTS", 1);
        add_entrance(text, shaders, true);
    }
    if (origin == Origin::eye) {
        text.file("effects/eye_begin.glsl");
        text.file("effects/surface_point.glsl");
    }
    text.file(shaders.march_takes_gradient ? "shade/gradient_from_state.glsl"
                                           : "shade/gradient_from_field.glsl");
    text.file("effects/end_of_ray.glsl");
    text.file("effects/store_surface.glsl");
    if (scene.ground) text.file("effects/ground.glsl");
    text.generated("generated: the first of what there is",
                   fmt::format("void main() {{\n    Ray ray = pixel_ray();\n"
                               "    RayState s = load_state();\n{}"
                               "    SurfacePoint p = end_of_ray(ray, s);\n{}"
                               "    store_surface(p);\n}}\n",
                               by_lists ? "    Ray in_beam = ray;\n    enter_beam(in_beam);\n"
                                          "    choose_list(s.low);\n"
                                        : "",
                               scene.ground ? "    p = before_ground(ray, p);\n" : ""));
    return text.take();
}

std::string shadow_text(const scene::Scene& scene, Shaders& shaders) {
    ShaderText text(shaders.files, shaders.stage);
    define_state(text, shaders);
    text.define("LIGHTS", int(scene.lights.size()));
    text.define("SHADOWS", shadow_mask(scene));
    if (shaders.light_beams != 0) {
        text.define("LIGHT_BEAMS", shaders.light_beams);
        if (has_lists(shaders)) text.define("LISTS", 1);
    }
    add_field(text, *scene.surface.field, shaders, shaders.samples);
    add_ray(text, scene);
    add_isolation(text, scene, shaders);
    text.file_of_stage("march/store_state.glsl", "stage/store_state.glsl");
    text.file("shade/shading.glsl");
    text.file("shade/hit.glsl");
    add_lights(text, scene);
    text.file("effects/surface_point.glsl");
    text.file("effects/load_surface.glsl");
    if (shaders.light_beams != 0) add_light_beams(text, shaders);
    if (const auto method = scene.isolation.method;
        method == scene::Method::hermite || scene::bounds_pieces(method)) {
        text.file("march/end_at_root.glsl");
        add_turn(text, scene, shaders);
        text.file("march/any_hit_turn.glsl");
    } else if (method == scene::Method::chebyshev) {
        text.file("march/end_at_root.glsl");
        add_turn(text, scene, shaders);
        text.file("march/any_hit_chebyshev.glsl");
    } else {
        text.file("march/any_hit_amp.glsl");
    }
    text.file("effects/shadow.glsl");
    text.file_of_stage("stage/march.frag", "stage/march.comp");
    return text.take();
}

std::string motion_text(const scene::Scene& scene, Shaders& shaders) {
    ShaderText text(shaders.files);
    add_field(text, *scene.surface.field, shaders, {FieldFunction::value, FieldFunction::gradient});
    add_ray(text, scene);
    text.file("effects/motion.frag");
    return text.take();
}

struct ChannelShader {
    Channel channel;
    const char* file;
    const char* function;
    const char* location;
};

constexpr ChannelShader channel_shaders[] = {
    {Channel::depth, "channels/depth.glsl", "write_depth", "DEPTH_LOCATION"},
    {Channel::normal, "channels/normal.glsl", "write_normal", "NORMAL_LOCATION"},
    {Channel::position, "channels/position.glsl", "write_position", "POSITION_LOCATION"},
    {Channel::ending, "channels/ending.glsl", "write_ending", "ENDING_LOCATION"},
};

// Returns the attachments they go to, from the third on.
std::vector<Channel> add_channels(ShaderText& text, const std::vector<Channel>& channels) {
    std::vector<Channel> attachments;
    std::string calls;
    for (const ChannelShader& shader : channel_shaders) {
        if (!contains(channels, shader.channel)) continue;
        text.define(shader.location, 2 + int(attachments.size()));
        text.file(shader.file);
        calls += fmt::format("    {}(ray, hit, verdict);\n", shader.function);
        attachments.push_back(shader.channel);
    }
    text.generated("generated: the channels asked for",
                   "void write_channels(Ray ray, Hit hit, int verdict) {\n" + calls + "}\n");
    return attachments;
}

bool has_flat_shading(const scene::Scene& scene) {
    return scene.lights.size() == 1 && !keeps_surfaces(scene);
}

// March and picture in one, where nothing but the picture needs to know where rays ended.
std::string whole_text(const scene::Scene& scene, const std::vector<Channel>& channels,
                       Shaders& shaders) {
    if (keeps_surfaces(scene) || scene.material.paint || contains(channels, Channel::velocity)) {
        return {};
    }
    ShaderText text(shaders.files);
    define_state(text, shaders);
    text.define("LIGHTS", int(scene.lights.size()));
    std::vector<FieldFunction> functions = shaders.samples;
    if (!shaders.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    add_field(text, *scene.surface.field, shaders, functions);
    add_ray(text, scene);
    add_march(text, scene, shaders, Origin::eye);
    text.file(has_flat_shading(scene) ? "shade/shading_flat.glsl" : "shade/shading.glsl");
    text.file("shade/hit.glsl");
    text.file("shade/record.glsl");
    text.file(scene.material.inside ? "shade/two_sided.glsl" : "shade/one_sided.glsl");
    text.file("shade/lambert.glsl");
    text.file(shaders.march_takes_gradient ? "shade/gradient_from_state.glsl"
                                           : "shade/gradient_from_field.glsl");
    add_channels(text, channels);
    text.file("shade/shade.glsl");
    text.file("shade/whole.frag");
    return text.take();
}

std::string open_text(const scene::Scene& scene, Shaders& shaders) {
    ShaderText text(shaders.files);
    text.file("math/bits.glsl");
    add_ray(text, scene);
    add_way(text, shaders, uses_beams(scene));
    text.file("march/open.frag");
    return text.take();
}

std::string shade_text(const scene::Scene& scene, const std::vector<Channel>& channels,
                       Shaders& shaders) {
    ShaderText text(shaders.files);
    text.define("LIGHTS", int(scene.lights.size()));
    const bool from_surface = keeps_surfaces(scene);
    const formula::Field& field = *scene.surface.field;
    const auto& paint = scene.material.paint;
    std::vector<GeneratedFunction> painting;
    if (paint) painting = paint_functions(*paint->value, field);
    std::vector<FieldFunction> functions;
    // Paint may ask for the gradient too.
    if (!shaders.march_takes_gradient && (!from_surface || paint)) {
        functions.push_back(FieldFunction::gradient);
    }
    if (from_surface && scene.occlusion) functions.push_back(FieldFunction::value);
    if (!functions.empty() || paint) {
        add_field(text, field, shaders, functions, painting);
    } else {
        text.file("math/bits.glsl");
    }
    add_ray(text, scene);
    text.file(has_flat_shading(scene) ? "shade/shading_flat.glsl" : "shade/shading.glsl");
    text.file("shade/hit.glsl");
    text.file("shade/record.glsl");
    if (paint) {
        add_paint(text, *paint);
    } else {
        text.file(scene.material.inside ? "shade/two_sided.glsl" : "shade/one_sided.glsl");
    }
    if (from_surface) {
        text.file("effects/eye_begin.glsl");
        text.file("effects/surface_point.glsl");
        text.file("effects/load_surface.glsl");
        add_shading(text, scene);
    } else {
        text.file("shade/lambert.glsl");
    }
    if (!from_surface || paint) {
        text.file(shaders.march_takes_gradient ? "shade/gradient_from_state.glsl"
                                               : "shade/gradient_from_field.glsl");
    }
    shaders.attachments = add_channels(text, channels);
    if (!from_surface) text.file("shade/shade.glsl");
    text.file(from_surface ? "effects/shade.frag" : "shade/shade.frag");
    return text.take();
}

} // namespace

bool uses_beams(const scene::Scene& scene) {
    return scene.isolation.beam.value_or(scene.isolation.method == scene::Method::hermite &&
                                         bounds_pay(*scene.surface.field));
}

Shaders assemble(const scene::Scene& scene, const std::vector<Channel>& channels, Stage stage,
                 bool writes_buffers, int finest_beam) {
    Shaders shaders;
    shaders.stage = stage;
    static_cast<FieldStorage&>(shaders) = storage_of(scene, writes_buffers);
    shaders.vertex = "#version 330 core\n" + read_shader("fullscreen.vert");
    shaders.shade_vertex = has_flat_shading(scene) ? "#version 330 core\n#define FLAT_SHADING\n" +
                                                         read_shader("fullscreen.vert")
                                                   : shaders.vertex;
    shaders.files.emplace_back("fullscreen.vert");
    shaders.march_takes_gradient = is_long(scene.surface.field->gradient);
    shaders.samples = samples_of(scene.isolation.method, shaders.march_takes_gradient);
    if (scene.isolation.method == scene::Method::chebyshev) {
        shaders.degree = scene::solved_degree(*scene.surface.field);
    }
    shaders.state_textures = scene.isolation.method == scene::Method::hermite ? 3 : 2;
    if (uses_beams(scene)) add_beams(scene, shaders, finest_beam);
    shaders.march = march_text(scene, shaders, Origin::eye);
    ShaderText active(shaders.files);
    active.file("march/state.glsl");
    active.file("march/active.frag");
    shaders.active = active.take();
    if (keeps_surfaces(scene)) shaders.surface = surface_text(scene, shaders, Origin::eye);
    // A polynomial is solved from where the eye's rays begin, off the surface: shadow rays from the
    // light end on it.
    if (uses_beams(scene) && scene.isolation.method != scene::Method::chebyshev)
        shaders.light_beams = shadow_mask(scene) & far_lights(scene);
    if (shadow_mask(scene) != 0) shaders.shadow = shadow_text(scene, shaders);
    if (scene.material.reflection == scene::Material::Reflection::self) {
        shaders.mirror = march_text(scene, shaders, Origin::mirror);
        shaders.mirror_surface = surface_text(scene, shaders, Origin::mirror);
    }
    if (contains(channels, Channel::velocity)) {
        shaders.motion = motion_text(scene, shaders);
    }
    if (scene.isolation.certify) {
        shaders.block_proof = block_proof_text(scene, shaders);
        shaders.begin_proof = begin_proof_text(scene, shaders);
        shaders.proof = proof_text(scene, shaders, ProofBounds::natural);
        shaders.sharp_proof = proof_text(scene, shaders, ProofBounds::by_gradient);
        shaders.double_proof = proof_text(scene, shaders, ProofBounds::in_doubles);
        shaders.to_prove = to_prove_text(scene, shaders);
        shaders.close_proofs = close_proofs_text(shaders.files);
        shaders.keep = keep_text(shaders.files);
    }
    std::vector<Channel> written = channels;
    if (scene.isolation.certify) written.push_back(Channel::ending);
    shaders.shade = shade_text(scene, written, shaders);
    shaders.whole = whole_text(scene, written, shaders);
    if (!shaders.whole.empty()) shaders.open = open_text(scene, shaders);
    return shaders;
}

std::string fingerprint(const Shaders& shaders) {
    base::Fingerprint print;
    for (const auto& level : shaders.beams) print.add(level.text);
    for (const std::string* text :
         {&shaders.march, &shaders.surface, &shaders.shadow, &shaders.mirror,
          &shaders.mirror_surface, &shaders.motion, &shaders.shade_vertex, &shaders.shade,
          &shaders.whole, &shaders.open, &shaders.proof, &shaders.sharp_proof, &shaders.to_prove,
          &shaders.block_proof, &shaders.begin_proof, &shaders.double_proof}) {
        print.add(*text);
    }
    return print.text();
}

} // namespace isomotion::synthesis
