#include "scene/reading/surfer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <glm/glm.hpp>

#include "scene/error.h"
#include "scene/limits.h"
#include "scene/reading/toml_lines.h"
#include "scene/srgb.h"

namespace isomotion::scene {
namespace {

struct Property {
    std::string value;
    std::size_t line = 0; // from 0
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\r'; }

std::string trimmed(std::string text) {
    while (!text.empty() && is_blank(text.back())) text.pop_back();
    text.erase(0, std::size_t(std::ranges::find_if_not(text, is_blank) - text.begin()));
    return text;
}

// Java's format: "key=value" or "key: value", # and ! begin comments, \ continues a line or makes
// the next character an ordinary one.
class Properties {
public:
    Properties(std::string_view text, std::filesystem::path file)
        : file_(std::move(file)) {
        for (std::size_t begin = 0; begin <= text.size(); ++lines_) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            std::string logical = trimmed(std::string(text.substr(begin, end - begin)));
            begin = end + 1;
            const std::size_t line = lines_;
            while (logical.ends_with('\\') && begin <= text.size()) {
                logical.pop_back();
                const std::size_t next = std::min(text.find('\n', begin), text.size());
                logical += trimmed(std::string(text.substr(begin, next - begin)));
                begin = next + 1;
                ++lines_;
            }
            add(logical, line);
        }
    }

    std::size_t lines() const { return lines_; }
    const std::map<std::string, Property>& all() const { return properties_; }
    const Property* find(const std::string& key) const {
        const auto found = properties_.find(key);
        return found == properties_.end() ? nullptr : &found->second;
    }
    std::size_t line_of(const std::string& key) const {
        const Property* found = find(key);
        return found ? found->line : lines_;
    }

    [[noreturn]] void fail(const std::string& key, const std::string& message) const {
        const Property* found = find(key);
        throw SceneError(fmt::format("{}:{}: {}: {}", file_.string(), found ? found->line + 1 : 1,
                                     key, message));
    }

    // `size` finite numbers; none if the file doesn't say.
    std::optional<std::vector<double>> numbers(const std::string& key, std::size_t size) const {
        const Property* found = find(key);
        if (!found) return std::nullopt;
        std::vector<double> values;
        const char* at = found->value.c_str();
        for (char* end = nullptr; values.size() <= size; at = end) {
            const double value = std::strtod(at, &end);
            if (end == at || !std::isfinite(value)) break;
            values.push_back(value);
        }
        if (values.size() != size || !trimmed(at).empty()) {
            fail(key, size == 1 ? "must be a number"
                                : fmt::format("must be {} numbers with spaces between", size));
        }
        return values;
    }
    double number(const std::string& key, double otherwise) const {
        const auto found = numbers(key, 1);
        return found ? found->front() : otherwise;
    }
    glm::dvec3 vector(const std::string& key, const glm::dvec3& otherwise) const {
        const auto found = numbers(key, 3);
        return found ? glm::dvec3((*found)[0], (*found)[1], (*found)[2]) : otherwise;
    }
    // Reads a matrix row by row.
    glm::dmat4 matrix(const std::string& key, const glm::dmat4& otherwise) const {
        const auto found = numbers(key, 16);
        if (!found) return otherwise;
        glm::dmat4 matrix;
        for (int k = 0; k < 16; ++k) matrix[k % 4][k / 4] = (*found)[std::size_t(k)];
        return matrix;
    }

private:
    void add(const std::string& line, std::size_t number) {
        if (line.empty() || line[0] == '#' || line[0] == '!') return;
        std::string key, value;
        bool is_in_value = false;
        for (std::size_t k = 0; k < line.size(); ++k) {
            const bool is_plain = line[k] == '\\' && k + 1 < line.size();
            const char c = is_plain ? line[++k] : line[k];
            if (!is_in_value && !is_plain && (c == '=' || c == ':')) {
                is_in_value = true;
            } else {
                (is_in_value ? value : key) += c;
            }
        }
        properties_[trimmed(key)] = {trimmed(value), number};
    }

    std::filesystem::path file_;
    std::map<std::string, Property> properties_;
    std::size_t lines_ = 0;
};

void put_surface(const Properties& from, double radius, TomlLines& to) {
    const Property* equation = from.find("surface_equation");
    if (!equation || equation->value.empty())
        from.fail("surface_equation", "is missing; write surface_equation=x^2+y^2+z^2-1");
    to.put(equation->line, "surface.formula", toml_text(equation->value));
    to.put(from.line_of("scale_factor"), "surface.bounds",
           fmt::format("{{ sphere = {} }}", radius));
    constexpr std::string_view start = "surface_parameter_";
    for (const auto& [key, property] : from.all()) {
        if (!key.starts_with(start)) continue;
        const std::string name = key.substr(start.size());
        if (name.empty() || !std::ranges::all_of(name, [](unsigned char c) {
                return std::isalnum(c) || c == '_';
            })) {
            from.fail(key, "a parameter's name is letters, digits and _");
        }
        const double value = from.number(key, 0);
        // Files name parameters that their equation left behind.
        if (names_word(equation->value, name))
            to.put(property.line, "parameters." + name, fmt::format("{}", value));
    }
}

// `turn`: from the viewer's coordinates to the surface's.
void put_camera(const Properties& from, const glm::dmat3& turn, double radius, TomlLines& to) {
    const Property* type = from.find("camera_type");
    const bool is_perspective = type && type->value == "PERSPECTIVE_CAMERA";
    if (type && !is_perspective && type->value != "ORTHOGRAPHIC_CAMERA") {
        from.fail("camera_type",
                  "must be ORTHOGRAPHIC_CAMERA or PERSPECTIVE_CAMERA, not " + type->value);
    }
    glm::dmat4 standard(1);
    standard[3].z = -1;
    const glm::dmat4 view = from.matrix("camera_transform", standard);
    const glm::dmat3 axes = glm::transpose(glm::dmat3(view)); // the camera's, in its columns
    const glm::dvec3 eye = -(axes * glm::dvec3(view[3]));
    const glm::dvec3 back = axes[2];
    // Parallel rays begin outside of the ball.
    const glm::dvec3 from_where =
        is_perspective ? eye : eye - glm::dot(eye, back) * back + 3.0 * back;
    to.put(from.line_of("camera_transform"), "camera.position",
           toml_text(radius * (turn * from_where)));
    to.put(from.lines(), "camera.target", toml_text(radius * (turn * (from_where - 3.0 * back))));
    to.put(from.line_of("rotation_matrix"), "camera.up", toml_text(turn * axes[1]));
    if (is_perspective) {
        to.put(from.line_of("camera_fov_y"), "camera.fov",
               fmt::format("{}", from.number("camera_fov_y", 60)));
    } else {
        to.put(from.line_of("camera_type"), "camera.projection", "\"orthographic\"");
        to.put(from.line_of("camera_height"), "camera.height",
               fmt::format("{}", radius * from.number("camera_height", 2)));
    }
}

// What is reflected straight on; theirs is a factor of the highlight. Old files misspell it.
double specular_of(const Properties& from) {
    const double gloss = from.number("front_material_specular_intensity",
                                     from.number("front_material_specular_iIntensity", 0.5));
    return std::clamp(0.3 * gloss, 0.0, 0.9);
}

void put_material(const Properties& from, TomlLines& to) {
    const auto color = [&](const std::string& side) {
        return to_linear(from.vector(side + "_material_color", {0.7, 0.2, 0.2}));
    };
    to.put(from.line_of("front_material_color"), "material.color", toml_text(color("front")));
    to.put(from.line_of("back_material_color"), "material.back_color", toml_text(color("back")));
    to.put(from.lines(), "material.model", "\"blinn-phong\"");
    const std::string shininess = "front_material_shininess";
    to.put(from.line_of(shininess), "material.shininess",
           fmt::format("{}", std::clamp(from.number(shininess, 30), 0.0, 10'000.0)));
    to.put(from.line_of("front_material_specular_intensity"), "material.specular",
           fmt::format("{}", specular_of(from)));
}

// Lights stand still before the viewer's eye while the surface turns.
void put_lights(const Properties& from, const glm::dmat3& turn, double radius, TomlLines& to) {
    const double ambient = from.number("front_material_ambient_intensity", 0.4);
    const double diffuse = from.number("front_material_diffuse_intensity", 0.8);
    std::vector<std::string> lights;
    for (std::size_t k = 0; k < limits::lights; ++k) {
        const auto key = [&](const char* name) { return fmt::format("light_{}_{}", name, k); };
        const Property* status = from.find(key("status"));
        if (!status || status->value != "ON") continue;
        const glm::dvec3 color = from.vector(key("color"), glm::dvec3(1));
        const double intensity = from.number(key("intensity"), 1);
        const glm::dvec3 position = from.vector(key("position"), {-100, 100, 100});
        const glm::dvec3 linear =
            to_linear(ambient + diffuse * intensity * color) - to_linear(ambient);
        // What is not mirrored is scattered.
        const glm::dvec3 scattered = glm::max(linear, glm::dvec3(0)) / (1 - specular_of(from));
        lights.push_back(fmt::format("{{ position = {}, color = {} }}",
                                     toml_text(radius * (turn * position)), toml_text(scattered)));
    }
    if (lights.empty()) return;
    to.put(from.line_of("light_status_0"), "lights", fmt::format("[{}]", fmt::join(lights, ", ")));
}

} // namespace

std::string surfer_as_toml(std::string_view text, const std::filesystem::path& file) {
    const Properties from(text, file);
    const double radius = std::pow(10.0, from.number("scale_factor", 0));
    if (!(radius > 1e-30) || !(radius < 1e30))
        from.fail("scale_factor", "must be from -30 to 30: the power of ten that the bounds are");
    const glm::dmat3 turn(from.matrix("rotation_matrix", glm::dmat4(1)));
    TomlLines to(from.lines());
    put_surface(from, radius, to);
    put_camera(from, turn, radius, to);
    put_material(from, to);
    put_lights(from, turn, radius, to);
    to.put(from.line_of("background_color"), "output.background",
           toml_text(to_linear(from.vector("background_color", glm::dvec3(1)))));
    return to.text();
}

} // namespace isomotion::scene
