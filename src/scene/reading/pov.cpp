#include "scene/reading/pov.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/reading/pov_transform.h"
#include "scene/reading/pov_values.h"
#include "scene/reading/pov_words.h"
#include "scene/reading/toml_lines.h"

namespace isomotion::scene {
namespace {

using Vector = std::vector<PovNumber>;

std::string value_text(const PovNumber& n) { return n.is_plain() ? n.text : toml_text(n.text); }

std::string vector_text(const Vector& v) {
    return fmt::format("[{}, {}, {}]", value_text(v[0]), value_text(v[1]), value_text(v[2]));
}

// From POV-Ray's axes to ours.
Vector swapped(const Vector& v) { return {v[0], v[2], v[1]}; }

PovNumber times(const PovNumber& n, double factor) {
    if (const auto value = n.plain()) return PovNumber::of(*value * factor);
    return {fmt::format("{}*({})", factor, n.text), PovNumber::Strength::product, std::nullopt};
}

PovNumber plus(const PovNumber& a, const PovNumber& b) {
    const auto first = a.plain(), second = b.plain();
    if (first && second) return PovNumber::of(*first + *second);
    return {fmt::format("({}) + ({})", a.text, b.text), PovNumber::Strength::sum, std::nullopt};
}

// How a surface looks, as far as that is read.
struct Look {
    std::optional<Vector> color;
    double diffuse = 0.6, highlight = 0, shininess = 40;
};

class PovScene {
public:
    PovScene(const std::vector<PovWord>& words, const std::filesystem::path& file)
        : at_(words, file)
        , lines_(words.back().line + 1)
        , last_line_(words.back().line) {}

    std::string toml() {
        while (!at_.at_end()) statement();
        if (!has_surface_) {
            at_.fail("isosurface", "is missing; a scene is one isosurface, poly, cubic, quartic or "
                                   "quadric");
        }
        put_lights();
        put_look();
        if (!has_background_) put(last_line_, "output.background", "[0, 0, 0]");
        put_parameters();
        return lines_.text();
    }

private:
    struct Bounds {
        std::size_t line = 0;
        std::string text;
        bool is_hint = false;
    };

    void put(std::size_t line, const std::string& key, const std::string& value) {
        lines_.put(line, key, value);
        said_ += value + "\n";
    }

    void statement() {
        const PovWord word = at_.now();
        if (word.is(";")) {
            at_.take();
        } else if (word.is("#declare") || word.is("#local")) {
            declare();
        } else if (word.is("#version")) {
            at_.take();
            values_.value(at_, "#version");
        } else if (word.is("#include")) {
            include();
        } else if (word.is("#default") || word.is("global_settings") || word.is("sky_sphere") ||
                   word.is("fog") || word.is("rainbow")) {
            at_.take();
            at_.skip_group(word.text);
        } else if (word.text.starts_with("#")) {
            at_.fail(word.text, "is not read; read are #declare, #local, #include and #version");
        } else if (word.is("camera")) {
            camera();
        } else if (word.is("light_source")) {
            light();
        } else if (word.is("background")) {
            background();
        } else if (word.is("plane")) {
            ground();
        } else {
            surface();
        }
    }

    void declare() {
        at_.take();
        const std::string name = at_.take().text;
        at_.expect("=", "#declare " + name);
        if (values_.declare(name, at_)) return;
        const PovWord word = at_.now();
        objects_[name] = at_.place();
        if (word.is("texture") || word.is("pigment") || word.is("finish") || word.is("material")) {
            Look look;
            read_look(look);
            looks_[name] = look;
        } else {
            at_.take();
            if (!at_.now().is("{"))
                at_.fail("#declare " + name, fmt::format("'{}' is not read here", word.text));
            at_.skip_group("#declare " + name);
        }
        at_.take_if(";");
    }

    // Passes over files of POV-Ray's own: what they declare is known, if it is read.
    void include() {
        static constexpr std::string_view known[] = {"colors.inc",  "functions.inc", "textures.inc",
                                                     "shapes.inc",  "metals.inc",    "math.inc",
                                                     "finish.inc",  "consts.inc",    "rad_def.inc",
                                                     "shapes2.inc", "transforms.inc"};
        const PovWord word = at_.take();
        if (std::ranges::count(known, at_.now().text) == 0) {
            at_.fail("#include", fmt::format("\"{}\" is not read: put what it holds into this file",
                                             at_.now().text));
        }
        at_.take();
    }

    void background() {
        const std::size_t line = at_.take().line;
        at_.expect("{", "background");
        const Vector color = values_.vector(at_, "background");
        at_.expect("}", "background");
        const auto still = still_vector(color);
        if (!still) at_.fail("background", "must not move");
        put(line, "output.background", toml_text(*still));
        has_background_ = true;
    }

    // ----- the camera

    double length_of(const Vector& v, std::string_view key) const {
        double sum = 0;
        for (const PovNumber& n : v) {
            if (!n.value) at_.fail(key, "must be of a length that does not move");
            sum += *n.value * *n.value;
        }
        if (!(sum > 0)) at_.fail(key, "must be no vector of zeros");
        return std::sqrt(sum);
    }

    void camera() {
        const std::size_t line = at_.take().line;
        const PovNumber zero = PovNumber::of(0), one = PovNumber::of(1);
        Vector location{zero, zero, zero}, sky{zero, one, zero};
        Vector target; // none: along the third axis
        Vector angle;  // one number, or none
        std::size_t location_line = line, target_line = line, angle_line = line;
        double right = 4.0 / 3, up = 1, ahead = 1;
        bool is_orthographic = false;
        at_.expect("{", "camera");
        while (!at_.take_if("}")) {
            const PovWord word = at_.now();
            if (at_.at_end()) at_.fail("camera", "its braces do not close");
            at_.take();
            if (word.is("location")) {
                location = values_.vector(at_, word.text);
                location_line = word.line;
            } else if (word.is("look_at")) {
                target = values_.vector(at_, word.text);
                target_line = word.line;
            } else if (word.is("angle")) {
                angle = {values_.number(at_, word.text)};
                angle_line = word.line;
            } else if (word.is("sky")) {
                sky = values_.vector(at_, word.text);
            } else if (word.is("right")) {
                right = length_of(values_.vector(at_, word.text), word.text);
            } else if (word.is("up")) {
                up = length_of(values_.vector(at_, word.text), word.text);
            } else if (word.is("direction")) {
                ahead = length_of(values_.vector(at_, word.text), word.text);
            } else if (word.is("orthographic")) {
                is_orthographic = true;
            } else if (!word.is("perspective")) {
                at_.fail("camera",
                         fmt::format("'{}' is not read; read are location, look_at, angle, "
                                     "sky, right, up, direction, perspective and "
                                     "orthographic",
                                     word.text));
            }
        }
        if (target.empty()) target = {location[0], location[1], plus(location[2], one)};
        put(location_line, "camera.position", vector_text(swapped(location)));
        put(target_line, "camera.target", vector_text(swapped(target)));
        put(line, "camera.up", vector_text(swapped(sky)));
        if (is_orthographic) {
            put(line, "camera.projection", "\"orthographic\"");
            put(line, "camera.height", fmt::format("{}", up));
        } else {
            put(angle_line, "camera.fov", fov_text(angle, right, up, ahead));
        }
        constexpr double width = 640;
        const double height = std::round(width * up / right);
        if (height >= 1 && height <= limits::picture_side)
            put(line, "output.size", fmt::format("[{}, {}]", width, height));
    }

    // The field of view upwards, where POV-Ray's angle is across.
    static std::string fov_text(const Vector& angle, double right, double up, double ahead) {
        using std::numbers::pi;
        if (angle.empty()) return fmt::format("{}", 2 * std::atan(0.5 * up / ahead) * 180 / pi);
        if (const auto plain = angle[0].plain()) {
            const double half = std::tan(*plain * pi / 360) * up / right;
            return fmt::format("{}", 2 * std::atan(half) * 180 / pi);
        }
        return toml_text(
            fmt::format("360/pi*atan({}*tan(({})*pi/360))", up / right, angle[0].text));
    }

    // ----- lights and ground

    struct Light {
        std::size_t line;
        Vector position, color;
        std::optional<Vector> towards; // far away
        bool shadow = true;
    };

    void light() {
        Light light{at_.take().line, {}, {}, std::nullopt};
        at_.expect("{", "light_source");
        light.position = values_.vector(at_, "light_source");
        at_.take_if(",");
        light.color = values_.vector(at_, "light_source");
        Vector point_at(3, PovNumber::of(0));
        bool is_parallel = false;
        while (!at_.take_if("}")) {
            const PovWord word = at_.now();
            if (word.is("shadowless")) {
                light.shadow = false;
                at_.take();
            } else if (word.is("parallel")) {
                is_parallel = true;
                at_.take();
            } else if (word.is("point_at")) {
                at_.take();
                point_at = values_.vector(at_, "point_at");
            } else {
                at_.fail("light_source",
                         fmt::format("'{}' is not read; read are a place, a colour, "
                                     "parallel, point_at and shadowless",
                                     word.text));
            }
        }
        if (is_parallel) {
            light.towards = Vector{};
            for (std::size_t k = 0; k < 3; ++k)
                light.towards->push_back(plus(light.position[k], times(point_at[k], -1)));
        }
        all_lights_.push_back(light);
        if (all_lights_.size() > limits::lights)
            at_.fail("light_source", fmt::format("a scene has at most {}", limits::lights));
    }

    void put_lights() {
        std::vector<std::string> lights;
        for (const Light& light : all_lights_) {
            Vector color;
            for (const PovNumber& part : light.color)
                color.push_back(times(part, look_.diffuse / (1 - mirrored(look_))));
            lights.push_back(fmt::format(
                "{{ {} = {}, color = {}, shadow = {} }}", light.towards ? "direction" : "position",
                vector_text(swapped(light.towards ? *light.towards : light.position)),
                vector_text(color), light.shadow));
        }
        if (!lights.empty())
            put(all_lights_.front().line, "lights", fmt::format("[{}]", fmt::join(lights, ", ")));
    }

    // The one plane that is read: level, under everything.
    void ground() {
        const std::size_t line = at_.take().line;
        at_.expect("{", "plane");
        const Vector normal = values_.vector(at_, "plane");
        at_.expect(",", "plane");
        const PovNumber height = values_.number(at_, "plane");
        const auto is = [](const PovNumber& n, double wanted) { return n.value == wanted; };
        if (!is(normal[0], 0) || !is(normal[1], 1) || !is(normal[2], 0))
            at_.fail("plane", "is read with the normal y: it is the ground");
        if (has_ground_) at_.fail("plane", "is the second; a scene has one ground");
        has_ground_ = true;
        Look look;
        while (!at_.take_if("}")) {
            if (!read_look(look))
                at_.fail("plane", fmt::format("'{}' is not read", at_.now().text));
        }
        put(line, "ground.height", value_text(height));
        if (look.color) put(line, "ground.color", vector_text(*look.color));
    }

    // ----- how a surface looks

    // Reads a part of a look, if it is at one.
    bool read_look(Look& look) {
        const PovWord word = at_.now();
        if (word.is("pigment")) {
            at_.take();
            read_pigment(look);
        } else if (word.is("finish")) {
            at_.take();
            read_finish(look);
        } else if (word.is("texture") || word.is("material")) {
            at_.take();
            at_.expect("{", word.text);
            while (!at_.take_if("}")) {
                if (take_declared_look(look) || read_look(look)) continue;
                at_.fail(word.text, fmt::format("'{}' is not read", at_.now().text));
            }
        } else if (word.is("normal") || word.is("interior")) {
            at_.take();
            at_.skip_group(word.text);
        } else if (word.is("no_shadow") || word.is("hollow") || word.is("double_illuminate") ||
                   word.is("sturm") || word.is("open") || word.is("all_intersections") ||
                   word.is("inverse") || word.is("uv_mapping")) {
            at_.take();
        } else {
            return false;
        }
        return true;
    }

    bool take_declared_look(Look& look) {
        const auto found = looks_.find(at_.now().text);
        if (found == looks_.end()) return false;
        at_.take();
        const Look& known = found->second;
        if (known.color) look.color = known.color;
        if (known.highlight > 0) {
            look.highlight = known.highlight;
            look.shininess = known.shininess;
        }
        if (known.diffuse != Look{}.diffuse) look.diffuse = known.diffuse;
        return true;
    }

    void read_pigment(Look& look) {
        const std::size_t begin = at_.place();
        at_.expect("{", "pigment");
        if (!take_declared_look(look)) {
            if (!values_.is_color(at_.now()))
                at_.fail("pigment",
                         "its pattern is not read; write pigment { color rgb <1, 0, 0> }");
            look.color = values_.vector(at_, "pigment");
        }
        at_.go_to(begin);
        at_.skip_group("pigment");
    }

    void read_finish(Look& look) {
        at_.expect("{", "finish");
        while (!at_.take_if("}")) {
            if (at_.at_end()) at_.fail("finish", "its braces do not close");
            if (take_declared_look(look)) continue;
            const PovWord word = at_.take();
            if (word.is("diffuse")) {
                look.diffuse = values_.constant(at_, word.text);
            } else if (word.is("phong") || word.is("specular")) {
                look.highlight = values_.constant(at_, word.text);
            } else if (word.is("phong_size")) {
                look.shininess = values_.constant(at_, word.text);
            } else if (word.is("roughness")) {
                look.shininess = 1 / std::max(values_.constant(at_, word.text), 1e-4);
            } else if (at_.now().is("{")) {
                at_.skip_group("finish");
            }
        }
    }

    // What the surface reflects straight on of POV-Ray's highlight.
    static double mirrored(const Look& look) { return std::clamp(0.3 * look.highlight, 0.0, 0.9); }

    void put_look() {
        if (look_.color) put(look_line_, "material.color", vector_text(*look_.color));
        if (!(look_.highlight > 0)) return;
        put(look_line_, "material.model", "\"blinn-phong\"");
        put(look_line_, "material.shininess",
            fmt::format("{}", std::clamp(look_.shininess, 0.0, 10'000.0)));
        put(look_line_, "material.specular", fmt::format("{}", mirrored(look_)));
    }

    // ----- the surface

    void surface() {
        const PovWord word = at_.now();
        if (word.is("object")) return object();
        const bool is_read = word.is("isosurface") || word.is("poly") || word.is("cubic") ||
                             word.is("quartic") || word.is("quadric");
        if (!is_read) {
            at_.fail(word.text, "is not read; a scene is one isosurface, poly, cubic, quartic or "
                                "quadric, with camera, light_source, background and plane");
        }
        if (has_surface_) at_.fail(word.text, "is the second; a scene has one surface");
        has_surface_ = true;
        look_line_ = word.line;
        at_.take();
        at_.expect("{", word.text);
        PovNumber formula;
        if (word.is("poly")) {
            const double order = values_.constant(at_, "poly");
            if (!(order >= 2 && order <= 35) || order != std::round(order))
                at_.fail("poly", "must have an order from 2 to 35");
            at_.expect(",", "poly");
            formula = polynomial(int(order), "poly");
        } else if (word.is("cubic")) {
            formula = polynomial(3, "cubic");
        } else if (word.is("quartic")) {
            formula = polynomial(4, "quartic");
        } else if (word.is("quadric")) {
            formula = quadric();
        }
        PovNumber threshold = PovNumber::of(0);
        while (!at_.take_if("}")) surface_part(word, formula, threshold);
        if (word.is("isosurface") && !has_function_)
            at_.fail("isosurface", "needs function { ... }");
        const bool is_zero = threshold.value == 0.0;
        put(word.line, "surface.formula",
            toml_text(is_zero ? formula.text
                              : fmt::format("{} - ({})", formula.text, threshold.text)));
        if (const auto transform = transform_.toml())
            put(word.line, "surface.transform", *transform);
        if (!bounds_ && word.is("isosurface")) // POV-Ray's own
            bounds_ = Bounds{word.line, "{ box = [[-1, -1, -1], [1, 1, 1]] }"};
        if (bounds_) put(bounds_->line, "surface.bounds", bounds_->text);
    }

    void surface_part(const PovWord& of, PovNumber& formula, PovNumber& threshold) {
        const PovWord word = at_.now();
        if (at_.at_end()) at_.fail(of.text, "its braces do not close");
        if (transform_.read(at_, values_) || read_look(look_)) return;
        if (of.is("isosurface") && word.is("function")) {
            at_.take();
            formula = values_.function(at_);
            has_function_ = true;
        } else if (word.is("threshold")) {
            at_.take();
            threshold = values_.number(at_, word.text);
        } else if (word.is("contained_by") || word.is("clipped_by") || word.is("bounded_by")) {
            at_.take();
            bounds(word);
        } else if (word.is("accuracy") || word.is("max_gradient") || word.is("max_trace")) {
            at_.take();
            values_.number(at_, word.text);
        } else if (word.is("evaluate")) {
            at_.take();
            for (int k = 0; k < 3; ++k) {
                if (k > 0) at_.expect(",", "evaluate");
                values_.number(at_, "evaluate");
            }
        } else {
            at_.fail(of.text, fmt::format("'{}' is not read here", word.text));
        }
    }

    void object() {
        at_.take();
        at_.expect("{", "object");
        const auto found = objects_.find(at_.now().text);
        if (found == objects_.end()) {
            at_.fail("object", fmt::format("'{}' is not declared before", at_.now().text));
        }
        at_.take();
        const std::size_t behind = at_.place();
        at_.go_to(found->second);
        if (at_.now().is("object")) at_.fail("object", "an object of an object is not read");
        surface();
        at_.go_to(behind);
        while (!at_.now().is("}")) {
            if (read_look(look_)) continue;
            if (at_.at_end()) at_.fail("object", "its braces do not close");
            at_.fail("object", fmt::format("'{}' is not read here; put it into the object's own "
                                           "declaration",
                                           at_.now().text));
        }
        at_.take();
    }

    void bounds(const PovWord& word) {
        at_.expect("{", word.text);
        const PovWord shape = at_.take();
        // bounded_by { clipped_by }: the same shape for both.
        if (shape.is("clipped_by") || shape.is("bounded_by")) return at_.expect("}", word.text);
        if (shape.is("sphere") || shape.is("box")) {
            at_.expect("{", word.text);
            const Vector first = swapped(values_.vector(at_, word.text));
            at_.expect(",", word.text);
            if (shape.is("sphere")) {
                const PovNumber radius = values_.number(at_, word.text);
                put_bounds(word, fmt::format("{{ sphere = {}, centre = {} }}", value_text(radius),
                                             vector_text(first)));
            } else {
                put_box(word, first, swapped(values_.vector(at_, word.text)));
            }
            at_.expect("}", word.text);
        } else {
            at_.fail(word.text, "is read with a sphere or a box");
        }
        at_.expect("}", word.text);
    }

    void put_box(const PovWord& word, Vector low, Vector high) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto &first = low[k].value, &second = high[k].value;
            if (first && second && *first > *second) std::swap(low[k], high[k]);
        }
        put_bounds(word, fmt::format("{{ box = [{}, {}] }}", vector_text(low), vector_text(high)));
    }

    // bounded_by only saves time, so that it counts where nothing else bounds the surface.
    void put_bounds(const PovWord& word, const std::string& text) {
        const bool is_hint = word.is("bounded_by");
        if (bounds_ && is_hint) return;
        if (bounds_ && !bounds_->is_hint)
            at_.fail(word.text, "is the second shape; the bounds are one sphere or one box");
        bounds_ = Bounds{word.line, text, is_hint};
    }

    // Coefficients in POV-Ray's order: x^n, x^(n-1) y, x^(n-1) z, x^(n-1) ... 1.
    PovNumber polynomial(int order, std::string_view key) {
        at_.expect("<", key);
        std::string sum;
        bool is_first = true;
        for (int a = order; a >= 0; --a) {
            for (int b = order - a; b >= 0; --b) {
                for (int c = order - a - b; c >= 0; --c) {
                    if (!is_first && !at_.take_if(",")) {
                        at_.fail(key, fmt::format("needs {} numbers",
                                                  (order + 1) * (order + 2) * (order + 3) / 6));
                    }
                    is_first = false;
                    add_term(values_.number(at_, key), a, b, c, sum);
                }
            }
        }
        if (!at_.now().is(">")) {
            at_.fail(key, fmt::format("has more than {} numbers",
                                      (order + 1) * (order + 2) * (order + 3) / 6));
        }
        at_.take();
        return {sum.empty() ? "0" : sum, PovNumber::Strength::sum, std::nullopt};
    }

    // `b` is the power of POV-Ray's y, which is our z.
    static void add_term(const PovNumber& factor, int a, int b, int c, std::string& sum) {
        if (factor.value == 0.0) return;
        const auto plain = factor.plain();
        std::string term =
            plain ? fmt::format("{}", std::abs(*plain)) : fmt::format("({})", factor.text);
        const bool is_negative = plain && *plain < 0;
        const auto multiply = [&](char name, int power) {
            if (power == 1) term += fmt::format("*{}", name);
            if (power > 1) term += fmt::format("*{}^{}", name, power);
        };
        multiply('x', a);
        multiply('z', b);
        multiply('y', c);
        if (!sum.empty())
            sum += is_negative ? " - " : " + ";
        else if (is_negative)
            sum += "-";
        sum += term;
    }

    // <A, B, C>, <D, E, F>, <G, H, I>, J: of x^2, y^2, z^2, xy, xz, yz, x, y, z and 1.
    PovNumber quadric() {
        static constexpr int powers[9][3] = {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {1, 0, 1},
                                             {0, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        std::string sum;
        for (int group = 0; group < 3; ++group) {
            const Vector factors = values_.vector(at_, "quadric");
            for (int k = 0; k < 3; ++k) {
                const auto& power = powers[3 * group + k];
                add_term(factors[std::size_t(k)], power[0], power[1], power[2], sum);
            }
            at_.expect(",", "quadric");
        }
        add_term(values_.number(at_, "quadric"), 0, 0, 0, sum);
        return {sum.empty() ? "0" : sum, PovNumber::Strength::sum, std::nullopt};
    }

    // Writes the clock, and the parameters that something names, also by way of others.
    void put_parameters() {
        const auto& all = values_.parameters();
        for (std::size_t k = all.size(); k-- > 0;) {
            if (!names_word(said_, all[k].name)) continue;
            const PovValues::Parameter& parameter = all[k];
            const bool is_number =
                parameter.text.find_first_not_of("0123456789.-+e") == parameter.text.npos;
            put(parameter.line, "parameters." + parameter.name,
                is_number ? parameter.text : toml_text(parameter.text));
        }
        if (!names_word(said_, "clock")) return;
        put(last_line_, "parameters.clock", "\"t\"");
        put(last_line_, "time.frames", "31");
        put(last_line_, "time.fps", "30");
    }

    PovCursor at_;
    PovValues values_;
    TomlLines lines_;
    std::size_t last_line_, look_line_ = 0;
    std::string said_; // all values, to see what they name
    std::map<std::string, Look> looks_;
    std::map<std::string, std::size_t> objects_; // where their words begin
    std::vector<Light> all_lights_;
    Look look_;
    PovTransform transform_;
    std::optional<Bounds> bounds_;
    bool has_surface_ = false, has_function_ = false, has_ground_ = false, has_background_ = false;
};

} // namespace

std::string pov_as_toml(std::string_view text, const std::filesystem::path& file) {
    const std::vector<PovWord> words = pov_words(text, file);
    return PovScene(words, file).toml();
}

} // namespace isomotion::scene
