#include "field_on_gpu.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>

#include "gpu/buffer.h"
#include "shader/field_text.h"
#include "shader/shader_text.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::shader {
namespace {

constexpr int width = 64;

enum Binding : unsigned { binding_parameters, binding_arrays };

std::vector<glm::vec4> packed(const std::vector<int>& fields, int texels,
                              const formula::ArrayColumns<float>& array) {
    std::vector<glm::vec4> all(std::size_t(array.count) * std::size_t(texels));
    for (int e = 0; e < array.count; ++e) {
        for (int slot = 0; slot < int(fields.size()); ++slot) {
            const auto& column = array.fields[std::size_t(fields[std::size_t(slot)])];
            all[std::size_t(e * texels + slot / 4)][slot % 4] = column[std::size_t(e)];
        }
    }
    return all;
}

std::size_t block_bytes(const FieldStorage& storage) {
    return std::size_t(storage.parameter_vectors + storage.count_vectors) * 16;
}

gpu::Texture texture_of(const std::vector<Probe>& probes, int height, glm::vec3 Probe::*part) {
    std::vector<float> texels(std::size_t(width * height) * 4);
    for (std::size_t k = 0; k < probes.size(); ++k) {
        std::memcpy(&texels[4 * k], &(probes[k].*part), sizeof(glm::vec3));
    }
    return {gpu::Format::rgba32f, width, height, texels};
}

// What the names of a field stand for, on the GPU.
class FieldValues {
public:
    FieldValues(const FieldStorage& storage, const formula::ArrayPacking& packing,
                const formula::Bindings<float>& bindings);

    // Texture units below `first_free_unit` are taken.
    void bind(const gpu::Program& program, int first_free_unit) const;

private:
    struct ArrayOnGpu {
        std::string name;
        std::optional<gpu::UniformBuffer> block;
        std::optional<gpu::TextureBuffer> buffer;
    };
    gpu::UniformBuffer parameters_;
    std::vector<ArrayOnGpu> arrays_;
};

FieldValues::FieldValues(const FieldStorage& storage, const formula::ArrayPacking& packing,
                         const formula::Bindings<float>& bindings)
    : parameters_(block_bytes(storage)) {
    std::vector<std::byte> block(block_bytes(storage));
    const auto values = std::as_bytes(std::span(bindings.parameters));
    std::copy(values.begin(), values.end(), block.begin());
    std::byte* counts = block.data() + storage.parameter_vectors * 16;
    for (std::size_t a = 0; a < storage.arrays.size(); ++a) {
        const std::int32_t count = bindings.arrays[a].count;
        std::memcpy(counts + 4 * a, &count, 4);
        const auto texels = packed(packing[a], storage.arrays[a].texels, bindings.arrays[a]);
        ArrayOnGpu& array = arrays_.emplace_back();
        array.name = storage.arrays[a].name;
        const auto capacity =
            std::size_t(storage.arrays[a].capacity) * std::size_t(storage.arrays[a].texels);
        if (storage.arrays[a].kind == ArrayStorage::Kind::uniform_block) {
            array.block.emplace(capacity * 16).update(std::as_bytes(std::span(texels)));
        } else {
            array.buffer.emplace(capacity).update(texels);
        }
    }
    parameters_.update(block);
}

void FieldValues::bind(const gpu::Program& program, int first_free_unit) const {
    parameters_.bind(binding_parameters);
    program.bind_block("Parameters", binding_parameters);
    for (std::size_t a = 0; a < arrays_.size(); ++a) {
        const ArrayOnGpu& array = arrays_[a];
        if (array.block) {
            array.block->bind(binding_arrays + unsigned(a));
            program.bind_block(array.name + "_block", binding_arrays + unsigned(a));
        } else {
            array.buffer->bind(first_free_unit + int(a));
            program.bind_sampler(array.name, first_free_unit + int(a));
        }
    }
}

// Calls each function of the field for a probe a pixel.
std::string probe_shader(const formula::Field& field, const FieldStorage& storage) {
    ShaderText text;
    add_field(text, field, storage,
              {FieldFunction::value, FieldFunction::directional, FieldFunction::gradient});
    text.generated("a probe a pixel", R"(
uniform sampler2D points, directions;
layout(location = 0) out vec4 value;
layout(location = 1) out vec4 along;
layout(location = 2) out vec4 gradient;

void main() {
    vec3 p = texelFetch(points, ivec2(gl_FragCoord.xy), 0).xyz;
    vec3 d = texelFetch(directions, ivec2(gl_FragCoord.xy), 0).xyz;
    value = vec4(field(p), 0.0, 0.0, 0.0);
    along = vec4(field_directional(p, d), 0.0, 0.0);
    gradient = vec4(field_gradient(p), 0.0);
}
)");
    return text.text();
}

} // namespace

std::array<std::vector<glm::vec4>, 3> run_on_gpu(const formula::Field& field,
                                                 const formula::Bindings<float>& bindings,
                                                 const std::vector<Probe>& probes) {
    std::vector<int> counts;
    for (const auto& array : bindings.arrays) counts.push_back(array.count);
    const FieldStorage storage = field_storage(field, int(bindings.parameters.size()), counts);
    const gpu::Program program(gpu::fullscreen_vertex, probe_shader(field, storage), "probes");
    const FieldValues values(storage, field.packing, bindings);

    const int height = (int(probes.size()) + width - 1) / width;
    const gpu::Texture points = texture_of(probes, height, &Probe::p);
    const gpu::Texture directions = texture_of(probes, height, &Probe::d);
    const gpu::Target target(width, height, int(field_functions.size()));
    values.bind(program, 2);
    points.bind(0);
    directions.bind(1);
    program.bind_sampler("points", 0);
    program.bind_sampler("directions", 1);
    target.bind();
    program.use();
    gpu::Fullscreen().draw();
    std::array<std::vector<glm::vec4>, 3> results;
    for (std::size_t f = 0; f < results.size(); ++f) {
        const std::vector<float> pixels = target.read(int(f), 0, 0, width, height);
        results[f].resize(probes.size());
        std::memcpy(results[f].data(), pixels.data(), probes.size() * sizeof(glm::vec4));
    }
    return results;
}

namespace {

std::string bounds_shader(const formula::Field& field, const FieldStorage& storage) {
    ShaderText text;
    add_field(text, field, storage,
              {FieldFunction::value_interval, FieldFunction::directional_interval,
               FieldFunction::gradient_interval});
    text.generated("a box a pixel", R"(
uniform sampler2D first, second, third;
layout(location = 0) out vec4 value;
layout(location = 1) out vec4 along;
layout(location = 2) out vec4 gradient;
layout(location = 3) out vec4 rest;

void main() {
    vec4 a = texelFetch(first, ivec2(gl_FragCoord.xy), 0);
    vec4 b = texelFetch(second, ivec2(gl_FragCoord.xy), 0);
    vec4 c = texelFetch(third, ivec2(gl_FragCoord.xy), 0);
    vec2 gx, gy, gz;
    field_gradient_interval(a.xy, a.zw, b.xy, gx, gy, gz);
    value = vec4(field_interval(a.xy, a.zw, b.xy), 0.0, 0.0);
    along = field_directional_interval(a.xy, a.zw, b.xy, b.zw, c.xy, c.zw);
    gradient = vec4(gx, gy);
    rest = vec4(gz, 0.0, 0.0);
}
)");
    return text.text();
}

} // namespace

std::vector<GpuBounds> bounds_on_gpu(const formula::Field& field,
                                     const formula::Bindings<float>& bindings,
                                     const std::vector<GpuBox>& boxes) {
    std::vector<int> counts;
    for (const auto& array : bindings.arrays) counts.push_back(array.count);
    const FieldStorage storage = field_storage(field, int(bindings.parameters.size()), counts);
    const gpu::Program program(gpu::fullscreen_vertex, bounds_shader(field, storage), "boxes");
    const FieldValues values(storage, field.packing, bindings);
    const int height = (int(boxes.size()) + width - 1) / width;
    const auto part = [&](std::size_t first) {
        std::vector<float> texels(std::size_t(width * height) * 4);
        for (std::size_t k = 0; k < boxes.size(); ++k)
            std::memcpy(&texels[4 * k], &boxes[k][first], 4 * sizeof(float));
        return gpu::Texture(gpu::Format::rgba32f, width, height, texels);
    };
    const std::array inputs{part(0), part(2), part(4)};
    const gpu::Target target(width, height, 4);
    values.bind(program, int(inputs.size()));
    const std::array names{"first", "second", "third"};
    for (int k = 0; k < int(inputs.size()); ++k) {
        inputs[std::size_t(k)].bind(k);
        program.bind_sampler(names[std::size_t(k)], k);
    }
    target.bind();
    program.use();
    gpu::Fullscreen().draw();
    std::vector<GpuBounds> results(boxes.size());
    struct Place {
        int attachment, component;
    };
    constexpr std::array<Place, 6> places{{{0, 0}, {1, 0}, {1, 2}, {2, 0}, {2, 2}, {3, 0}}};
    for (std::size_t o = 0; o < places.size(); ++o) {
        const auto pixels = target.read(places[o].attachment, 0, 0, width, height);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            const float* at = &pixels[4 * k + std::size_t(places[o].component)];
            results[k].outputs[o] = {at[0], at[1]};
        }
    }
    return results;
}

namespace {

// Doubles come and go as four whole numbers of 16 bits, lowest first.
constexpr int parts = 4;

void put(double value, float* into) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int k = 0; k < parts; ++k) into[k] = float(bits >> (16 * k) & 0xffff);
}

double take(const float* from) {
    std::uint64_t bits = 0;
    for (int k = 0; k < parts; ++k) bits |= std::uint64_t(from[k]) << (16 * k);
    return std::bit_cast<double>(bits);
}

// A box takes twelve rows of the input; a draw gives one output, both of its ends.
std::string double_bounds_shader(const formula::Field& field, const FieldStorage& storage) {
    ShaderText text;
    text.version(400);
    add_enclosures(text, field, storage,
                   {FieldFunction::value_interval, FieldFunction::directional_interval,
                    FieldFunction::gradient_interval},
                   formula::Numbers::doubles);
    text.generated("a box a pixel", R"(
uniform sampler2D boxes;
uniform int wanted;
layout(location = 0) out vec4 low;
layout(location = 1) out vec4 high;

double joined(int k) {
    ivec2 at = ivec2(gl_FragCoord.xy);
    uvec4 bits = uvec4(texelFetch(boxes, ivec2(at.x, 12 * at.y + k), 0));
    return packDouble2x32(uvec2(bits.x | bits.y << 16, bits.z | bits.w << 16));
}

vec4 parted(double x) {
    uvec2 bits = unpackDouble2x32(x);
    return vec4(bits.x & 0xffffu, bits.x >> 16, bits.y & 0xffffu, bits.y >> 16);
}

void main() {
    // No arrays: NVIDIA's compiler rounds their doubles to floats where the index is no constant.
    dvec2 x = dvec2(joined(0), joined(1)), y = dvec2(joined(2), joined(3));
    dvec2 z = dvec2(joined(4), joined(5)), dx = dvec2(joined(6), joined(7));
    dvec2 dy = dvec2(joined(8), joined(9)), dz = dvec2(joined(10), joined(11));
    dvec4 along = field_directional_interval(x, y, z, dx, dy, dz);
    dvec2 gx, gy, gz;
    field_gradient_interval(x, y, z, gx, gy, gz);
    dvec2 b = field_interval(x, y, z);
    if (wanted == 1) b = along.xy;
    if (wanted == 2) b = along.zw;
    if (wanted == 3) b = gx;
    if (wanted == 4) b = gy;
    if (wanted == 5) b = gz;
    low = parted(b.x);
    high = parted(b.y);
}
)");
    return text.text();
}

} // namespace

std::vector<DoubleBox> double_bounds_on_gpu(const formula::Field& field,
                                            const formula::Bindings<float>& bindings,
                                            const std::vector<DoubleBox>& boxes) {
    std::vector<int> counts;
    for (const auto& array : bindings.arrays) counts.push_back(array.count);
    const FieldStorage storage = field_storage(field, int(bindings.parameters.size()), counts);
    const gpu::Program program(gpu::fullscreen_vertex, double_bounds_shader(field, storage),
                               "boxes of doubles");
    const FieldValues values(storage, field.packing, bindings);
    const int height = (int(boxes.size()) + width - 1) / width;
    std::vector<float> texels(std::size_t(width * height) * 12 * parts);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const std::size_t column = k % width, row = k / width;
        for (std::size_t end = 0; end < 12; ++end) {
            put(boxes[k][end / 2][int(end % 2)],
                &texels[((12 * row + end) * width + column) * parts]);
        }
    }
    const gpu::Texture input(gpu::Format::rgba32f, width, 12 * height, texels);
    const gpu::Target target(width, height, 2);
    values.bind(program, 1);
    program.bind_sampler("boxes", 0);
    std::vector<DoubleBox> results(boxes.size());
    for (std::size_t output = 0; output < 6; ++output) {
        target.bind();
        input.bind(0);
        program.set("wanted", int(output));
        program.use();
        gpu::Fullscreen().draw();
        const auto low = target.read(0, 0, 0, width, height);
        const auto high = target.read(1, 0, 0, width, height);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            results[k][output] = {take(&low[parts * k]), take(&high[parts * k])};
        }
    }
    return results;
}

} // namespace isomotion::shader
