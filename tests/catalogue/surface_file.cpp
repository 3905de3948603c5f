#include "surface_file.h"

#include <fmt/format.h>

#include "scene/data_folder.h"
#include "scene/reading/document.h"
#include "unit/shader/scenes.h"

namespace isomotion::catalogue {

void use_source_tree() { shader::use_shaders_of_source_tree(); }

std::vector<Parameter> parameters_of(const std::string& surface) {
    use_source_tree();
    const toml::table file =
        scene::read_document(scene::data_folder() / "animations/surfaces" / (surface + ".toml"));
    std::vector<Parameter> parameters;
    const toml::table* section = file["parameters"].as_table();
    if (!section) return parameters;
    for (const auto& [name, node] : *section) {
        const toml::table* range = node.as_table();
        const auto number = [&](const char* key) {
            const auto value = range ? (*range)[key].value<double>() : std::nullopt;
            return value.value_or(std::numeric_limits<double>::quiet_NaN());
        };
        parameters.push_back(
            {std::string(name.str()), number("default"), number("min"), number("max")});
    }
    return parameters;
}

std::vector<std::vector<Setting>> ends_of_parameters(const std::string& surface) {
    std::vector<std::vector<Setting>> all{{}};
    for (const Parameter& parameter : parameters_of(surface)) {
        all.push_back({{parameter.name, parameter.min}});
        all.push_back({{parameter.name, parameter.max}});
    }
    return all;
}

std::vector<std::vector<Setting>> both_ends(const std::string& surface) {
    std::vector<std::vector<Setting>> all(3);
    for (const Parameter& parameter : parameters_of(surface)) {
        all[1].push_back({parameter.name, parameter.min});
        all[2].push_back({parameter.name, parameter.max});
    }
    return all;
}

std::string describe(const std::vector<Setting>& settings) {
    std::string text = settings.empty() ? "defaults" : "";
    for (const auto& [name, value] : settings) text += fmt::format("{} = {} ", name, value);
    return text;
}

Used used(const std::string& surface, const std::vector<Setting>& settings) {
    use_source_tree();
    std::string text = fmt::format("[surface]\nuse = \"{}\"\n[parameters]\n", surface);
    for (const auto& [name, value] : settings) text += fmt::format("{} = {}\n", name, value);
    Used result{shader::scene_of(text), {}};
    result.at = scene::at_frame(result.scene, 1);
    return result;
}

namespace {

glm::dvec3 in_box(const scene::BoundsAt& bounds, formula::Random& random) {
    const glm::dvec3 unit(random.in(0, 1), random.in(0, 1), random.in(0, 1));
    return bounds.min + unit * (bounds.max - bounds.min);
}

} // namespace

glm::dvec3 point_in(const scene::BoundsAt& bounds, formula::Random& random) {
    for (;;) {
        const glm::dvec3 p = in_box(bounds, random);
        const bool inside = bounds.shape == scene::Bounds::Shape::box ||
                            glm::distance(p, bounds.centre) < bounds.radius;
        if (inside) return p;
    }
}

glm::dvec3 point_on(const scene::BoundsAt& bounds, formula::Random& random) {
    if (bounds.shape == scene::Bounds::Shape::sphere) {
        glm::dvec3 p;
        do p = point_in(bounds, random);
        while (glm::distance(p, bounds.centre) < 0.01 * bounds.radius);
        return bounds.centre + bounds.radius * glm::normalize(p - bounds.centre);
    }
    glm::dvec3 p = in_box(bounds, random);
    const int face = random.below(6);
    p[face / 2] = face % 2 ? bounds.max[face / 2] : bounds.min[face / 2];
    return p;
}

} // namespace isomotion::catalogue
