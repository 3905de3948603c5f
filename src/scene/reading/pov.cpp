#include "scene/reading/pov.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/reading/pov_formula.h"
#include "scene/reading/pov_includes.h"
#include "scene/reading/pov_look.h"
#include "scene/reading/pov_moves.h"
#include "scene/reading/pov_shapes.h"
#include "scene/reading/pov_solids.h"
#include "scene/reading/pov_transform.h"
#include "scene/reading/pov_values.h"
#include "scene/reading/pov_words.h"
#include "scene/reading/toml_lines.h"
#include "scene/surfaces.h"

namespace isomotion::scene {
namespace {

using Vector = std::vector<PovNumber>;

constexpr std::size_t most_parts = 1000; // of unions of which each part is a surface

std::string value_text(const PovNumber& n) { return pov_value_text(n); }
std::string vector_text(const Vector& v) { return pov_vector_text(v); }

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

// The names in a value, whatever they stand for.
std::vector<std::string> words_of(std::string_view text) {
    const auto is_of_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
    std::vector<std::string> words;
    for (auto at = text.begin(); at != text.end();) {
        const auto end = std::find_if_not(at, text.end(), is_of_word);
        const auto begin = std::find_if_not(at, end, is_digit);
        if (begin != end) words.emplace_back(begin, end);
        at = end == text.end() ? end : end + 1;
    }
    return words;
}

bool may_jump(std::string_view formula) {
    static constexpr std::string_view jumping[] = {"if", "floor", "trunc", "atan2"};
    return std::ranges::any_of(words_of(formula), [](const std::string& word) {
        return std::ranges::count(jumping, word) > 0;
    });
}

class PovScene {
public:
    PovScene(const std::vector<PovWord>& words, const std::filesystem::path& file)
        : at_(words, file)
        , looks_(values_)
        , solids_(values_, looks_, moves_)
        , lines_(words.back().line + 1)
        , last_line_(words.back().line) {}

    std::string toml() {
        while (!at_.at_end()) statement();
        if (roots_.empty()) {
            at_.fail("isosurface", fmt::format("is missing; a scene is one object or up to {}: {}",
                                               most_surfaces, PovSolidReader::known_words()));
        }
        put_surfaces();
        put_lights();
        if (!has_background_) put(last_line_, "output.background", "[0, 0, 0]");
        put_parameters();
        return lines_.text();
    }

private:
    void put(std::size_t line, const std::string& key, const std::string& value) {
        lines_.put(line, key, value);
        std::ranges::copy(words_of(value), std::inserter(said_, said_.end()));
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
        } else if (!word.is("plane") || !ground()) {
            surface();
        }
    }

    void declare() {
        at_.take();
        const std::string name = at_.take().text;
        at_.expect("=", "#declare " + name);
        if (values_.declare(name, at_)) return forget(name, Kind::value);
        const PovWord word = at_.now();
        if (word.is("transform")) {
            std::vector<PovMove> moves;
            read_pov_move(at_, values_, moves_, moves);
            moves_[name] = moves;
            forget(name, Kind::move);
        } else if (PovSolidReader::is_solid(word)) {
            solids_.declare(name, at_);
            forget(name, Kind::solid);
        } else if (looks_.declare(name, at_)) {
            forget(name, Kind::look);
        } else {
            at_.take();
            if (!at_.now().is("{"))
                at_.fail("#declare " + name, fmt::format("'{}' is not read here", word.text));
            at_.skip_group("#declare " + name);
        }
        at_.take_if(";");
    }

    // What a name was before it was declared as something of this kind.
    enum class Kind { value, move, solid, look };
    void forget(const std::string& name, Kind now) {
        if (now != Kind::value) values_.forget(name);
        if (now != Kind::move) moves_.erase(name);
        if (now != Kind::solid) solids_.forget(name);
        if (now != Kind::look) looks_.forget(name);
    }

    // Passes over files of POV-Ray's own: what they declare is known, if it is read.
    void include() {
        const PovWord word = at_.take();
        if (!is_povs_own_file(at_.now().text)) {
            at_.fail("#include", fmt::format("\"{}\" is not read: put it, or what it holds, into "
                                             "this file's folder",
                                             at_.now().text));
        }
        at_.take();
    }

    void background() {
        const std::size_t line = at_.take().line;
        if (has_background_) at_.fail("background", "is there a second time");
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
        if (std::exchange(has_camera_, true)) at_.fail("camera", "is there a second time");
        const PovNumber zero = PovNumber::of(0), one = PovNumber::of(1);
        Vector location{zero, zero, zero}, sky{zero, one, zero};
        Vector target; // none: along the direction
        Vector direction{zero, zero, one};
        Vector angle; // one number, or none
        std::size_t location_line = line, target_line = line, angle_line = line;
        Vector right{PovNumber::of(4.0 / 3), zero, zero}, up{zero, one, zero};
        bool is_orthographic = false, has_size = false;
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
                right = values_.vector(at_, word.text);
                has_size = true;
            } else if (word.is("up")) {
                up = values_.vector(at_, word.text);
                has_size = true;
            } else if (word.is("direction")) {
                direction = values_.vector(at_, word.text);
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
        expect_unmirrored(right, up, direction);
        const double across = length_of(right, "right"), upwards = length_of(up, "up"),
                     ahead = length_of(direction, "direction");
        for (std::size_t k = 0; target.size() < 3; ++k)
            target.push_back(plus(location[k], direction[k]));
        eye_ = still_vector(location).value_or(eye_);
        put(location_line, "camera.position", vector_text(swapped(location)));
        put(target_line, "camera.target", vector_text(swapped(target)));
        put(line, "camera.up", vector_text(swapped(sky)));
        if (is_orthographic) {
            put(line, "camera.projection", "\"orthographic\"");
            const double scale =
                angle.empty() && has_size ? 1 : scale_at(location, target, angle, across, ahead);
            put(line, "camera.height", fmt::format("{}", upwards * scale));
        } else {
            put(angle_line, "camera.fov", fov_text(angle, across, upwards, ahead));
        }
        constexpr double width = 640;
        const double height = std::round(width * upwards / across);
        if (height >= 1 && height <= limits::picture_side)
            put(line, "output.size", fmt::format("[{}, {}]", width, height));
    }

    // `right` may point to the left: then POV-Ray's picture is mirrored.
    void expect_unmirrored(const Vector& right, const Vector& up, const Vector& direction) const {
        const auto r = still_vector(right), u = still_vector(up), d = still_vector(direction);
        if (r && u && d && glm::dot(glm::cross(*u, *d), *r) < 0) {
            at_.fail("right",
                     "points to the left, and a mirrored picture is not read: turn it round "
                     "and give all objects scale <-1, 1, 1>");
        }
    }

    // How much larger than `right` and `up` the picture of an orthographic camera is, by which it
    // shows at its target what one in perspective would.
    double scale_at(const Vector& location, const Vector& target, const Vector& angle, double right,
                    double ahead) const {
        const auto from = still_vector(location), to = still_vector(target);
        const char* still = "an orthographic camera must not move; give it right and up";
        if (!from || !to) at_.fail("camera", still);
        if (!angle.empty()) {
            const auto& degrees = angle[0].value;
            if (!degrees) at_.fail("camera", still);
            ahead = 0.5 * right / std::tan(*degrees * std::numbers::pi / 360);
        }
        return glm::distance(*from, *to) / ahead;
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
                color.push_back(times(part, look_.diffuse / (1 - look_.mirrored())));
            lights.push_back(fmt::format(
                "{{ {} = {}, color = {}, shadow = {} }}", light.towards ? "direction" : "position",
                vector_text(swapped(light.towards ? *light.towards : light.position)),
                vector_text(color), light.shadow));
        }
        if (!lights.empty())
            put(all_lights_.front().line, "lights", fmt::format("[{}]", fmt::join(lights, ", ")));
    }

    // The first plane that is level and stays as it is lies under everything. Goes back to where it
    // began if it is no such plane.
    bool ground() {
        const std::size_t begin = at_.place(), line = at_.take().line;
        at_.expect("{", "plane");
        const Vector normal = values_.vector(at_, "plane");
        at_.take_if(",");
        const PovNumber height = values_.number(at_, "plane");
        const auto is = [](const PovNumber& n, double wanted) { return n.value == wanted; };
        bool is_ground = !has_ground_ && is(normal[0], 0) && is(normal[1], 1) && is(normal[2], 0);
        PovLook look;
        while (is_ground && !at_.take_if("}")) is_ground = looks_.read(at_, look);
        if (!is_ground) {
            at_.go_to(begin);
            return false;
        }
        has_ground_ = true;
        put(line, "ground.height", value_text(height));
        if (look.color) put(line, "ground.color", vector_text(*look.color));
        return true;
    }

    // ----- the surfaces

    void surface() {
        const PovWord word = at_.now();
        if (!PovSolidReader::is_solid(word)) {
            at_.fail(word.text, fmt::format("is not read; a scene is objects ({}), camera, "
                                            "light_source and background",
                                            PovSolidReader::known_words()));
        }
        split(solids_.read(at_), roots_);
    }

    // A union shows its parts as they are. Those that may be seen from within another part, or look
    // otherwise, are surfaces of their own.
    void split(const PovSolid& solid, std::vector<PovSolid>& all) const {
        const bool is_cut = solid.bounds && !solid.bounds->is_hint;
        if (split_cut(solid, all)) return;
        if (solid.kind != PovSolid::Kind::unite || solid.is_inverse || is_cut ||
            (solid.is_closed && solid.looks.size() == 1)) {
            if (all.size() >= most_parts)
                at_.fail_in(solid.line, solid.word,
                            fmt::format("more than {} parts of unions", most_parts));
            all.push_back(solid);
            return;
        }
        for (const auto& part : solid.parts) {
            PovSolid one = *part;
            one.moves.insert(one.moves.end(), solid.moves.begin(), solid.moves.end());
            if (!one.look.color) one.look = solid.look;
            one.take_looks();
            split(one, all);
        }
    }

    // What cuts an object cuts each of its parts. Returns false unless the object is cut and has
    // parts that look otherwise.
    bool split_cut(const PovSolid& solid, std::vector<PovSolid>& all) const {
        PovSolid inner = solid;
        std::vector<std::shared_ptr<const PovSolid>> cuts;
        if (solid.bounds && !solid.bounds->is_hint) {
            PovSolid cut;
            cut.word = solid.word;
            cut.line = solid.line;
            cut.formula = solid.bounds->formula;
            cuts.push_back(std::make_shared<const PovSolid>(std::move(cut)));
            inner.bounds.reset();
            inner.moves.clear();
        } else if (solid.kind == PovSolid::Kind::clip) {
            cuts.assign(solid.parts.begin() + 1, solid.parts.end());
            inner = *solid.parts.front();
        }
        if (cuts.empty() || solid.is_inverse || inner.is_inverse || inner.looks.size() < 2)
            return false;
        std::vector<PovSolid> pieces;
        split(inner, pieces);
        if (pieces.size() < 2) return false;
        for (PovSolid& piece : pieces) {
            PovSolid outer;
            outer.kind = PovSolid::Kind::clip;
            outer.word = solid.word;
            outer.line = solid.line;
            outer.depth = solid.depth;
            outer.moves = solid.moves;
            outer.look = std::exchange(piece.look, PovLook{});
            if (!outer.look.color) outer.look = solid.look;
            piece.take_looks();
            outer.parts.push_back(std::make_shared<const PovSolid>(std::move(piece)));
            outer.parts.insert(outer.parts.end(), cuts.begin(), cuts.end());
            outer.take_looks();
            all.push_back(std::move(outer));
        }
        return true;
    }

    // The first colour among an object's parts that can be seen.
    static const PovLook* look_of(const PovSolid& solid) {
        if (solid.look.color) return solid.look.is_clear ? nullptr : &solid.look;
        for (const auto& part : solid.parts)
            if (part->is_colored) return look_of(*part);
        return nullptr;
    }

    // So many surfaces that a scene can have them: closed ones of one look are one; then all are.
    void join() {
        if (roots_.size() > std::size_t(most_surfaces)) join_alike(false);
        if (roots_.size() > std::size_t(most_surfaces)) join_alike(true);
        if (roots_.size() > std::size_t(most_surfaces)) {
            at_.fail_in(roots_.back().line, roots_.back().word,
                        fmt::format("is one of {} objects that differ in their looks; a scene has "
                                    "at most {}",
                                    roots_.size(), most_surfaces));
        }
    }

    void join_alike(bool open_ones) {
        std::vector<PovSolid> groups;
        std::map<std::string, std::size_t> places; // by look
        for (PovSolid& root : roots_) {
            const PovLook* look = look_of(root);
            const bool is_whole = root.is_closed && !root.is_inverse;
            if (!look && root.look.is_clear) continue;
            if (!is_whole && !open_ones) {
                groups.push_back(std::move(root));
                continue;
            }
            const auto [place, is_new] =
                places.try_emplace(look ? look->text() : "", groups.size());
            if (is_new) {
                PovSolid group;
                group.word = root.word;
                group.line = root.line;
                group.is_closed = true;
                if (look) group.look = *look;
                groups.push_back(group);
            }
            PovSolid& group = groups[place->second];
            group.is_closed &= is_whole;
            group.is_endless |= root.is_endless;
            group.kind = group.is_closed ? PovSolid::Kind::unite : PovSolid::Kind::surfaces;
            group.parts.push_back(std::make_shared<const PovSolid>(std::move(root)));
        }
        roots_ = std::move(groups);
    }

    struct Key {
        std::size_t line;
        std::string name, value;
    };

    // The keys of one surface; none if nothing of it can be seen.
    std::vector<Key> keys_of(const PovSolid& solid) {
        PovTransform transform;
        bool is_similar = true;
        for (const PovMove& move : solid.moves) is_similar = is_similar && transform.add(move);
        PovSolid bare = solid;
        std::optional<PovBounds> bounds;
        if (solid.is_endless && !solid.bounds) is_similar = false; // bounds where they lie
        if (is_similar) {
            bare.moves.clear();
            bounds = std::exchange(bare.bounds, std::nullopt);
        }
        PovFormula formula(at_, [&](const std::string& name) {
            return values_.is_declared(name) || said_.contains(name);
        });
        const auto text = formula.of(bare);
        if (!text) return {};
        std::vector<Key> keys{{solid.line, "formula", toml_text(*text)}};
        if (is_similar) {
            if (const auto moved = transform.toml())
                keys.push_back({solid.line, "transform", *moved});
        }
        // POV-Ray finds a root wherever the sign changes.
        if (bare.kind == PovSolid::Kind::formula && solid.word == "isosurface" && may_jump(*text))
            keys.push_back({solid.line, "jumps", "true"});
        if (bounds) keys.push_back({bounds->line, "bounds", bounds->text});
        // As far as can be seen, nearly: what goes on without end has no bounds to find.
        if (!bounds && solid.is_endless) {
            const double reach = 20 * std::max(glm::length(eye_), 1.0);
            keys.push_back({solid.line, "bounds", pov_ball_bounds({eye_, reach})});
        }
        return keys;
    }

    static std::vector<Key> look_keys(const PovLook& look, std::size_t line) {
        std::vector<Key> keys;
        if (look.color) keys.push_back({line, "color", vector_text(*look.color)});
        if (!(look.highlight > 0)) return keys;
        keys.push_back({line, "model", "\"blinn-phong\""});
        keys.push_back(
            {line, "shininess", fmt::format("{}", std::clamp(look.shininess, 0.0, 10'000.0))});
        keys.push_back({line, "specular", fmt::format("{}", look.mirrored())});
        return keys;
    }

    static std::string table(const std::vector<Key>& keys) {
        std::vector<std::string> all(keys.size());
        std::ranges::transform(keys, all.begin(), [](const Key& key) {
            return fmt::format("{} = {}", key.name, key.value);
        });
        return fmt::format("{{ {} }}", fmt::join(all, ", "));
    }

    void put_surfaces() {
        join();
        std::vector<std::vector<Key>> all;
        std::vector<PovLook> looks;
        for (const PovSolid& root : roots_) {
            const std::vector<Key> keys = keys_of(root);
            if (keys.empty()) continue;
            all.push_back(keys);
            const PovLook* look = look_of(root);
            looks.push_back(look ? *look : root.look);
        }
        if (all.empty())
            at_.fail("pigment", "lets all light pass everywhere: nothing of the scene can be seen");
        look_ = looks[0];
        if (all.size() == 1) {
            for (const Key& key : all[0]) put(key.line, "surface." + key.name, key.value);
            for (const Key& key : look_keys(look_, all[0][0].line))
                put(key.line, "material." + key.name, key.value);
            return;
        }
        std::vector<std::string> tables;
        for (std::size_t k = 0; k < all.size(); ++k) {
            const auto look = look_keys(looks[k], 0);
            if (!look.empty()) all[k].push_back({0, "material", table(look)});
            tables.push_back(table(all[k]));
        }
        put(all[0][0].line, "surfaces", fmt::format("[{}]", fmt::join(tables, ", ")));
    }

    // Writes the clock, and the parameters that something names, also by way of others.
    void put_parameters() {
        const auto& all = values_.parameters();
        for (std::size_t k = all.size(); k-- > 0;) {
            if (!said_.contains(all[k].name)) continue;
            const PovValues::Parameter& parameter = all[k];
            const bool is_number =
                parameter.text.find_first_not_of("0123456789.-+e") == parameter.text.npos &&
                parameter.text.find_first_of("0123456789") != parameter.text.npos;
            put(parameter.line, "parameters." + parameter.name,
                is_number ? parameter.text : toml_text(parameter.text));
        }
        if (!said_.contains("clock")) return;
        put(last_line_, "parameters.clock", "\"t\"");
        put(last_line_, "time.frames", "31");
        put(last_line_, "time.fps", "30");
    }

    PovCursor at_;
    PovValues values_;
    PovLooks looks_;
    PovMoves moves_;
    PovSolidReader solids_;
    TomlLines lines_;
    std::size_t last_line_;
    std::set<std::string, std::less<>> said_; // the words of all values, to see what they name
    std::vector<PovSolid> roots_;
    std::vector<Light> all_lights_;
    PovLook look_;            // of the first surface
    glm::dvec3 eye_{0, 0, 0}; // the camera
    bool has_ground_ = false, has_background_ = false, has_camera_ = false;
};

} // namespace

std::string pov_as_toml(std::string_view text, const std::filesystem::path& file) {
    const std::vector<PovWord> words = pov_words_with_includes(text, file);
    return PovScene(words, file).toml();
}

} // namespace isomotion::scene
