#include "scene/reading/mathmod.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "base/extension.h"
#include "base/nearest_name.h"
#include "base/printable.h"
#include "formula/graph/vocabulary.h"
#include "scene/limits.h"
#include "scene/reading/mathmod_json.h"
#include "scene/reading/mathmod_values.h"
#include "scene/reading/toml_lines.h"
#include "scene/srgb.h"
#include "scene/surfaces.h"

namespace isomotion::scene {
namespace mathmod {
namespace {

using Kind = JsonValue::Kind;

constexpr const char* iso = "Iso3D";
constexpr const char* kinds[] = {iso, "ParIso", "Param3D", "Param4D"};
constexpr std::size_t longest_list = 6000; // bytes of names in a message
constexpr std::size_t longest_name = 64;   // of a surface

std::string trimmed(std::string_view text) {
    const auto is_blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    return std::string(text);
}

const JsonValue* find_kind(const JsonValue& script) {
    for (const char* kind : kinds) {
        if (const JsonValue* found = script.find(kind)) return found;
    }
    return nullptr;
}

std::string name_of(const JsonValue& script) {
    const JsonValue* kind = find_kind(script);
    const JsonValue* name = kind ? kind->find("Name") : nullptr;
    if (name && name->kind == Kind::list && !name->items.empty()) name = &name->items.front();
    if (!name || name->kind != Kind::text) return "";
    const std::string title = base::printable_line(trimmed(name->text));
    return title.size() > limits::title_bytes ? "" : title;
}

std::string list_of(const std::vector<std::string>& names) {
    std::string list;
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (list.size() > longest_list)
            return list + fmt::format(", and {} more", names.size() - k);
        list += (k > 0 ? ", " : "") + names[k];
    }
    return list;
}

const JsonValue& one_of(const JsonValue& root, const std::filesystem::path& file,
                        const std::string& model) {
    const JsonValue* list = root.find("MathModels");
    std::vector<const JsonValue*> scripts;
    if (list) {
        for (const JsonValue& script : list->items) scripts.push_back(&script);
    } else if (find_kind(root)) {
        scripts.push_back(&root);
    }
    const JsonPlace place{&file, list ? list->line : 0, list ? "MathModels" : ""};
    if (scripts.empty()) {
        place.fail(list ? "has no models"
                        : "is JSON, but no script of MathMod: that has the key \"Iso3D\"");
    }
    if (model.empty() && scripts.size() == 1) return *scripts.front();
    std::vector<std::string> names;
    for (const JsonValue* script : scripts) {
        const std::string name = name_of(*script);
        if (!model.empty() && name == model) return *script;
        if (script->find(iso) && !name.empty()) names.push_back(name);
    }
    const std::string start = file.filename().string() + "#";
    if (names.empty()) place.fail("has no models of surfaces by equations (Iso3D) with names");
    if (model.empty()) {
        place.fail(fmt::format("has {} models; name one, as {}{}. Those of surfaces by equations: "
                               "{}",
                               scripts.size(), start, names.front(), list_of(names)));
    }
    const std::string near = base::nearest_name(model, names);
    place.fail(fmt::format("has no model '{}'; {}", model,
                           near.empty() ? "it has " + list_of(names)
                                        : fmt::format("did you mean '{}{}'?", start, near)));
}

class Script {
public:
    Script(const JsonValue& script, const std::filesystem::path& file)
        : script_(script)
        , file_(file) {
        const JsonValue* kind = find_kind(script);
        if (!kind) at(script, "").fail("is no script of MathMod: it needs the key \"Iso3D\"");
        surfaces_ = script.find(iso);
        if (!surfaces_) {
            for (const char* other : kinds) {
                if (script.find(other)) {
                    at(*kind, other)
                        .fail("is a surface by parameters u and v; only surfaces by an "
                              "equation are read, those of Iso3D");
                }
            }
        }
        if (surfaces_->kind != Kind::object)
            at(*surfaces_, iso).fail("must hold keys with lists: \"Fxyz\": [\"x^2 + y^2 - 1\"]");
    }

    std::string as_toml() {
        read_names();
        const JsonValue* fields = list("Fxyz");
        if (!fields || fields->items.empty())
            at(*surfaces_, "Fxyz").fail("is missing; write \"Fxyz\": [\"x^2 + y^2 + z^2 - 1\"]");
        const std::size_t count = fields->items.size();
        if (count > std::size_t(most_surfaces)) {
            at(*fields, "Fxyz")
                .fail(fmt::format("has {} components; at most {} are read", count, most_surfaces));
        }
        std::size_t last = 0;
        for (const JsonValue& field : fields->items) last = std::max(last, field.line);
        TomlLines to(last + 1);
        if (const std::string title = name_of(script_); !title.empty())
            to.put(line_of("Name"), "title", toml_text(title));
        std::vector<Component> components;
        for (std::size_t k = 0; k < count; ++k) components.push_back(component(*fields, k));
        if (count == 1)
            put_one(components.front(), to);
        else
            put_all(components, to);
        for (const std::string& parameter : parameters_)
            to.put(last + 1, "parameters." + parameter,
                   fmt::format("{}", values_.slider(parameter)));
        if (names_time_) to.put(last + 1, "parameters." + values_.time(), "\"t\"");
        if (moves_) to.put(last + 1, "time", "{ fps = 30, frames = 120 }");
        return to.text();
    }

private:
    struct Component {
        std::string name, formula, box;
        std::vector<std::string> color; // if it has any of its own
        bool may_jump = false;
        std::size_t formula_line = 0, box_line = 0, color_line = 0;
    };

    JsonPlace at(const JsonValue& value, const std::string& key) const {
        return {&file_, value.line, key};
    }
    std::size_t line_of(const std::string& key) const {
        const JsonValue* value = surfaces_->find(key);
        return value ? value->line : 0;
    }

    const JsonValue* list(const std::string& key) const { return list_in(*surfaces_, key); }
    // Its items are texts or numbers; null if there is none.
    const JsonValue* list_in(const JsonValue& object, const std::string& key) const {
        const JsonValue* found = object.find(key);
        if (!found) return nullptr;
        if (found->kind != Kind::list)
            at(*found, key).fail(fmt::format("must be a list: \"{}\": [\"...\"]", key));
        for (const JsonValue& item : found->items) {
            if (item.kind != Kind::text && item.kind != Kind::number)
                at(item, key).fail("must be a list of texts in quotes");
        }
        return found;
    }

    // Entries are NAME=EXPRESSION; MathMod joins them by semicolons.
    template<typename Add> void read_entries(const std::string& key, const Add& add) {
        const JsonValue* found = list(key);
        if (!found) return;
        std::size_t count = 0;
        for (const JsonValue& item : found->items) {
            std::string_view rest = item.text;
            while (!rest.empty()) {
                const std::size_t end = std::min(rest.find(';'), rest.size());
                const std::string entry = trimmed(rest.substr(0, end));
                rest.remove_prefix(std::min(end + 1, rest.size()));
                if (entry.empty()) continue;
                const JsonPlace place = at(item, key);
                if (++count > std::size_t(limits::parameters))
                    place.fail(fmt::format("has more than {} entries", limits::parameters));
                const std::size_t equals = std::min(entry.find('='), entry.size());
                const std::string name = trimmed(std::string_view(entry).substr(0, equals));
                expect_name(name, place);
                if (equals == entry.size())
                    place.fail(fmt::format("'{0}' has no value; write {0}=...", name));
                add(name, std::string_view(entry).substr(equals + 1), place);
            }
        }
    }
    static void expect_name(const std::string& name, const JsonPlace& place) {
        if (!formula::is_identifier(name))
            place.fail(fmt::format("'{}' is no name: a name is letters, digits and _", name));
        if (name.size() > longest_name - 4) // Ax of A, and signs that make it another name
            place.fail(fmt::format("a name of {} characters; at most {} are read", name.size(),
                                   longest_name - 4));
    }

    void read_names() {
        read_entries("Const",
                     [&](const std::string& name, std::string_view text, const JsonPlace& place) {
                         values_.add_constant(name, text, place);
                     });
        read_sliders();
        read_entries("Varu",
                     [&](const std::string& name, std::string_view text, const JsonPlace& place) {
                         values_.add_variable(name, text, place);
                     });
        read_entries("Funct",
                     [&](const std::string& name, std::string_view text, const JsonPlace& place) {
                         values_.add_function(name, text, place);
                     });
    }

    // Positions may be several sets of values; the first is shown.
    void read_sliders() {
        const JsonValue* sliders = script_.find("Sliders");
        if (!sliders || sliders->kind != Kind::object) return;
        const JsonValue* names = list_in(*sliders, "Name");
        if (!names) return;
        const JsonValue* positions = list_in(*sliders, "Position");
        const std::size_t count = positions ? positions->items.size() : 0;
        if (count < names->items.size()) {
            at(positions ? *positions : *sliders, "Sliders.Position")
                .fail(fmt::format("has {} value{} for {} sliders", count, count == 1 ? "" : "s",
                                  names->items.size()));
        }
        if (names->items.size() > std::size_t(limits::parameters)) {
            at(*names, "Sliders.Name")
                .fail(fmt::format("has more than {} sliders", limits::parameters));
        }
        for (std::size_t k = 0; k < names->items.size(); ++k) {
            const std::string name = trimmed(names->items[k].text);
            expect_name(name, at(names->items[k], "Sliders.Name"));
            const JsonValue& position = positions->items[k];
            const Part value = Values().limit(position.text, at(position, "Sliders.Position"));
            if (!value.value) at(position, "Sliders.Position").fail("must be a number");
            values_.add_slider(name, *value.value);
        }
    }

    void take_names(const Part& part) {
        parameters_.merge(values_.parameters_of(part));
        moves_ |= part.inputs.test(Part::t);
    }

    Component component(const JsonValue& fields, std::size_t k) {
        Component made;
        const JsonValue& field = fields.items[k];
        const Part part = values_.formula(field.text, at(field, "Fxyz"));
        take_names(part);
        names_time_ |= part.inputs.test(Part::t);
        made.formula = values_.definitions_for(part) + part.text;
        made.may_jump = part.may_jump;
        made.formula_line = field.line;
        made.name = component_name(k);
        put_limits(fields.items.size(), k, made);
        put_color(k, made);
        return made;
    }
    std::string component_name(std::size_t k) {
        const JsonValue* names = list("Component");
        if (!names || k >= names->items.size()) return "";
        std::string name = base::printable_line(trimmed(names->items[k].text));
        const bool is_new = names_.insert(name).second;
        return is_new && name.size() <= longest_name ? name : "";
    }

    void put_limits(std::size_t count, std::size_t k, Component& to) {
        std::array<std::array<Part, 3>, 2> corners;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t end = 0; end < 2; ++end) {
                const std::string key = std::string(1, "XYZ"[axis]) + (end == 0 ? "min" : "max");
                const JsonValue* found = list(key);
                if (!found)
                    at(*surfaces_, key)
                        .fail(fmt::format("is missing; write \"{}\": [\"{}\"]", key,
                                          end == 0 ? -1 : 1));
                if (k >= found->items.size()) {
                    at(*found, key)
                        .fail(fmt::format("has {} of the {} values that the components "
                                          "need",
                                          found->items.size(), count));
                }
                const JsonValue& item = found->items[k];
                if (axis == 0 && end == 0) to.box_line = item.line;
                corners[end][axis] = values_.limit(item.text, at(item, key));
                take_names(corners[end][axis]);
            }
            // MathMod steps from one end to the other, whichever is the greater.
            Part &low = corners[0][axis], &high = corners[1][axis];
            if (low.value && high.value && *low.value > *high.value) std::swap(low, high);
        }
        const auto text = [](const Part& limit) {
            return limit.value ? fmt::format("{}", *limit.value) : toml_text(limit.text);
        };
        const auto corner = [&](const std::array<Part, 3>& c) {
            return fmt::format("[{}, {}, {}]", text(c[0]), text(c[1]), text(c[2]));
        };
        to.box = fmt::format("{{ box = [{}, {}] }}", corner(corners[0]), corner(corners[1]));
    }

    // MathMod shows what fulfils a condition in green and the rest in red.
    void put_color(std::size_t k, Component& to) {
        const JsonValue* conditions = list("Cnd");
        if (!conditions || k >= conditions->items.size()) return;
        const JsonValue& item = conditions->items[k];
        if (trimmed(item.text).empty()) return;
        const Part part = values_.formula(item.text, at(item, "Cnd"));
        if (part.value) return; // all of one colour
        take_names(part);
        names_time_ |= part.inputs.test(Part::t);
        const double dark = to_linear(0.1), bright = to_linear(0.9);
        const auto choice = [&](double here, double there) {
            return toml_text(fmt::format("{}if({}, {:.4g}, {:.4g})", values_.definitions_for(part),
                                         part.condition(), here, there));
        };
        to.color = {choice(dark, bright), choice(bright, dark), "0"};
        to.color_line = item.line;
    }

    static void put_one(const Component& one, TomlLines& to) {
        to.put(one.formula_line, "surface.formula", toml_text(one.formula));
        to.put(one.box_line, "surface.bounds", one.box);
        if (one.may_jump) to.put(one.formula_line, "surface.jumps", "true");
        if (!one.color.empty())
            to.put(one.color_line, "material.color",
                   fmt::format("[{}]", fmt::join(one.color, ", ")));
    }
    // A list of tables, each of which TOML wants in one line.
    static void put_all(const std::vector<Component>& components, TomlLines& to) {
        std::vector<std::string> tables;
        for (const Component& one : components) {
            std::string table = "{ ";
            if (!one.name.empty()) table += fmt::format("name = {}, ", toml_text(one.name));
            table += fmt::format("formula = {}, bounds = {}", toml_text(one.formula), one.box);
            if (one.may_jump) table += ", jumps = true";
            if (!one.color.empty())
                table += fmt::format(", material = {{ color = [{}] }}", fmt::join(one.color, ", "));
            tables.push_back(table + " }");
        }
        to.put(components.front().formula_line, "surfaces",
               fmt::format("[{}]", fmt::join(tables, ", ")));
    }

    const JsonValue& script_;
    const std::filesystem::path& file_;
    const JsonValue* surfaces_ = nullptr;
    Values values_;
    std::set<std::string> parameters_, names_;
    bool moves_ = false, names_time_ = false;
};

} // namespace
} // namespace mathmod

bool is_json(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != text.npos && text[first] == '{';
}

std::optional<ModelName> model_name(const std::string& name) {
    const std::size_t sign = name.find('#');
    if (sign == name.npos) return std::nullopt;
    const std::string extension = base::lower_extension(name.substr(0, sign));
    if (extension != ".js" && extension != ".json") return std::nullopt;
    return ModelName{name.substr(0, sign), name.substr(sign + 1)};
}

std::string mathmod_as_toml(std::string_view text, const std::filesystem::path& file,
                            const std::string& model) {
    const mathmod::JsonValue root = mathmod::read_json(text, file);
    return mathmod::Script(mathmod::one_of(root, file, model), file).as_toml();
}

} // namespace isomotion::scene
