#include "page/frame_values.h"

#include <cmath>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <thread>
#include <variant>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include "elements/grid_maker.h"
#include "page/html.h"
#include "page/packed_grid.h"
#include "render/element_radius.h"
#include "render/sample_pattern.h"
#include "render/uniform_blocks.h"
#include "scene/error.h"
#include "scene/near_elements.h"
#include "scene/scene_at.h"
#include "shader/effect.h"

namespace isomotion::page {
namespace {

// A row of doubles and the names of its places.
class Row {
public:
    void add(const char* name, double number) { add(name, std::span(&number, 1)); }
    void add(const char* name, const glm::dvec3& v) { add(name, std::span(glm::value_ptr(v), 3)); }
    void add(const char* name, const glm::dmat3& m) {
        add(name, std::span(glm::value_ptr(m), 9)); // column by column
    }

    void add(const char* name, std::span<const double> all) {
        numbers.insert(numbers.end(), all.begin(), all.end());
        places.push_back({name, int(all.size())});
    }

    std::vector<double> numbers;
    std::vector<Place> places;
};

// Adds what the rays of all surfaces depend on: web/rays.js makes the block Frame of it, for the
// camera of whoever looks.
void add_camera(Row& row, const scene::SceneAt& now) {
    row.add("position", now.camera.position);
    row.add("target", now.camera.target);
    row.add("up", now.camera.up);
    row.add("fov", now.camera.fov);
    row.add("height", now.camera.height);
    row.add("zoom", now.camera.zoom);
    row.add("aperture", now.camera.aperture);
    row.add("focus", now.camera.focus);
    std::vector<double> radii;
    for (const scene::LightAt& light : now.lights) radii.push_back(light.radius);
    row.add("lightRadius", std::span<const double>(radii));
}

// Adds the values that are one surface's own.
void add_surface(Row& row, const scene::SurfaceAt& now, double element_radius) {
    row.add("translate", now.placement.translate);
    row.add("rotate", now.placement.rotate);
    row.add("scale", now.placement.scale);
    row.add("min", now.bounds.min);
    row.add("max", now.bounds.max);
    row.add("centre", now.bounds.centre);
    row.add("radius", now.bounds.radius);
    row.add("elementRadius", element_radius);
}

std::vector<std::uint32_t> words_of_bytes(std::span<const std::byte> bytes) {
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), words.size() * 4);
    return words;
}

std::vector<float> numbers_of(std::span<const glm::vec4> texels) {
    std::vector<float> floats;
    for (const glm::vec4& texel : texels)
        floats.insert(floats.end(), {texel.x, texel.y, texel.z, texel.w});
    return floats;
}

std::span<const float> floats_of(const float& value) { return {&value, 1}; }
template<glm::length_t n>
std::span<const float> floats_of(const glm::vec<n, float, glm::defaultp>& value) {
    return {glm::value_ptr(value), std::size_t(n)};
}
std::span<const float> floats_of(const std::vector<glm::vec4>& values) {
    return {glm::value_ptr(values.front()), 4 * values.size()};
}
template<class Other> std::span<const float> floats_of(const Other&) {
    throw std::logic_error("effects' uniforms are floats");
}

// Appends the numbers of the effects' uniforms; tells their places.
std::vector<Place> add_effects(const shader::Uniforms& uniforms, std::vector<float>& row) {
    std::vector<Place> places;
    for (const auto& [name, value] : uniforms) {
        const auto before = row.size();
        std::visit(
            [&](const auto& v) {
                const auto floats = floats_of(v);
                row.insert(row.end(), floats.begin(), floats.end());
            },
            value);
        places.push_back({name, int(row.size() - before)});
    }
    return places;
}

// Makes and packs the grids of the array whose elements are found by place, if there is one.
class Grids {
public:
    explicit Grids(const WebSurface& web)
        : web_(web) {
        if (const auto array = shader::array_with_grid(web.passes))
            maker_ = elements::GridMaker::of(*web.one.surface.field, *array);
        // A texture of 1024 x 2048, which every WebGL2 has, holds as many.
        limits_.listed = 1 << 21;
        limits_.threads = int(std::max(1u, std::thread::hardware_concurrency()));
    }

    std::optional<elements::ElementGrid> at(const scene::SurfaceAt& now) const {
        if (!maker_) return std::nullopt;
        auto grid = maker_->make(now.bindings, scene::region_of_elements(now.bounds), limits_);
        const std::uint32_t most = web_.plan.most_elements_at_a_place;
        if (grid.longest > most || grid.listed.size() > limits_.listed) {
            throw std::length_error(fmt::format(
                "{} elements of an array matter at one place, and lists have {} in all; a page can "
                "sum {} and hold {}: smaller kernels, or fewer elements in one place",
                grid.longest, grid.listed.size(), most, limits_.listed));
        }
        return grid;
    }

    void add(const elements::ElementGrid& grid, const scene::SurfaceAt& now,
             std::vector<std::byte>& into) const {
        std::vector<std::byte> packed;
        pack(grid, now.bindings.arrays[std::size_t(grid.array)].count, packed);
        for (int place = 0; place < 4; ++place)
            into.push_back(std::byte(packed.size() >> (8 * place) & 0xff));
        into.insert(into.end(), packed.begin(), packed.end());
    }

private:
    const WebSurface& web_;
    std::optional<elements::GridMaker> maker_;
    elements::GridLimits limits_;
};

// Makes the rows of one surface.
class SurfaceRows {
public:
    explicit SurfaceRows(const WebSurface& web)
        : web_(web)
        , by_cubics_(scene::traits(web.one.surface.isolation.method).steps == scene::Steps::cubics)
        , grids_(web) {}

    void prepare(SurfaceValues& values) const {
        for (std::size_t a = 0; a < web_.passes.arrays.size(); ++a)
            values.arrays.emplace_back(fmt::format("array{}", a));
    }

    void add(const scene::SceneAt& scene, SurfaceValues& values) {
        const scene::OneSurface& one = web_.one;
        const formula::Field& field = *one.surface.field;
        const scene::OneSurfaceAt now(scene, one.index);
        const scene::SurfaceAt& surface = now.surface;
        const shader::Passes& passes = web_.passes;
        Row view;
        if (one.index == 0) add_camera(view, scene);
        add_surface(view, surface, by_cubics_ ? element_radius_.least(field, surface) : HUGE_VAL);
        values.view.add(words_of(std::span<const double>(view.numbers)));
        values.view_places = std::move(view.places);
        const auto grid = grids_.at(surface);
        if (grid) grids_.add(*grid, surface, values.grids);
        values.parameters.add(
            words_of_bytes(render::parameter_block(passes, surface, grid ? &*grid : nullptr)));
        const auto shading = render::shading_block(one, now, largest_tile, largest_tile);
        values.shading.add(words_of(std::span<const float>(numbers_of(shading))));
        std::vector<float> effects;
        values.effect_places = add_effects(shader::effect_uniforms(one, now), effects);
        values.effects.add(words_of(std::span<const float>(effects)));
        for (std::size_t a = 0; a < passes.arrays.size(); ++a) {
            std::vector<glm::vec4> texels = render::array_texels(field, passes, surface, a);
            const auto& storage = passes.arrays[a];
            texels.resize(std::size_t(storage.capacity) * std::size_t(storage.texels));
            values.arrays[a].add(words_of(std::span<const float>(numbers_of(texels))));
        }
    }

private:
    const WebSurface& web_;
    bool by_cubics_;
    render::ElementRadius element_radius_;
    Grids grids_;
};

double bytes_of(const SurfaceValues& values, std::size_t rows) {
    std::size_t columns = 0;
    for (const ValueTable* table : values.tables()) columns += table->moving();
    return 4.0 * double(columns) * double(rows) + double(values.grids.size());
}

// Columns that move go on moving: a few rows show whether there is too much.
void expect_little_data(const scene::Scene& scene, const FrameValues& values, std::size_t rows) {
    double bytes = 0;
    for (const SurfaceValues& surface : values) bytes += bytes_of(surface, rows);
    if (bytes <= double(most_value_bytes)) return;
    throw scene::SceneError(fmt::format(
        "{}: the values of {} frames are {:.0f} MB or more; a page holds at most {}: take fewer "
        "frames (time.frames), samples (output.samples) or elements",
        scene.file.string(), scene.timeline.frames, bytes / 1e6, most_value_bytes / 1'000'000));
}

// Takes expressions in place of values where that is shorter.
void leave_out(const WebSurface& web, std::span<const double> times, SurfaceValues& values) {
    const auto counts_at = std::size_t(4 * web.passes.parameter_vectors);
    for (std::size_t a = 0; a < values.arrays.size(); ++a) {
        std::vector<int> counts;
        for (std::size_t row = 0; row < times.size(); ++row)
            counts.push_back(int(values.parameters.word(row, counts_at + a)));
        ValueTable& table = values.arrays[a];
        auto computed = computed_elements(web.one.surface, a, table, times, counts);
        if (computed) {
            ValueTable rest = without(*computed, web.one.surface, a, table);
            std::vector<std::byte> shorter, whole;
            rest.pack(shorter);
            pack(*computed, shorter);
            table.pack(whole);
            if (deflated_text(shorter).size() < deflated_text(whole).size())
                table = std::move(rest);
            else
                computed.reset();
        }
        values.computed.push_back(std::move(computed));
    }
}

} // namespace

std::vector<double> moments(const scene::Scene& scene) {
    if (scene.camera.shutter == 0) return {0.0};
    std::vector<double> parts;
    for (const render::Sample& sample : render::sample_pattern(scene.output.samples))
        parts.push_back(scene.camera.shutter * sample.part);
    return parts;
}

std::vector<const ValueTable*> SurfaceValues::tables() const {
    std::vector<const ValueTable*> all{&view, &parameters, &shading, &effects};
    for (const ValueTable& array : arrays) all.push_back(&array);
    return all;
}

FrameValues frame_values(const WebScene& web) {
    const scene::Scene& scene = *web.scene;
    FrameValues values(web.surfaces.size());
    std::vector<SurfaceRows> rows;
    for (const WebSurface& surface : web.surfaces) rows.emplace_back(surface);
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].prepare(values[k]);
    const auto add = [&](const scene::SceneAt& now) {
        for (std::size_t k = 0; k < rows.size(); ++k) rows[k].add(now, values[k]);
    };
    const std::vector<double> parts = moments(scene);
    std::vector<double> times;
    for (int frame = 1; frame <= scene.timeline.frames; ++frame) {
        for (const double part : parts) {
            add(scene::at_frame(scene, frame, part));
            times.push_back(scene.timeline.time(frame, part));
        }
        expect_little_data(scene, values, std::size_t(scene.timeline.frames) * parts.size());
    }
    for (std::size_t k = 0; k < web.surfaces.size(); ++k)
        leave_out(web.surfaces[k], times, values[k]);
    return values;
}

} // namespace isomotion::page
