#include "scene/reading/surface.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "formula/graph/parser.h"
#include "scene/data_folder.h"
#include "scene/key_sections.h"
#include "scene/key_tables.h"
#include "scene/limits.h"
#include "scene/reading/arrays.h"
#include "scene/reading/formula_words.h"
#include "scene/reading/names.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {
namespace {

struct Parameter {
    std::optional<animation::TrackSource> source; // none if it is wrong
    const toml::node* node = nullptr;
    std::string key;
    Range range;
};

// A surface file's parameter is { default = 6, min = 0.5, max = 20 }, or as in a scene, where it
// keeps the surface's range.
Parameter read_parameter(Section& parameters, const std::string& name, const Range& known) {
    const toml::node& node = *parameters.find(name);
    const std::string key = parameters.dotted(name);
    const toml::table* table = node.as_table();
    if (!table || table->contains("keys")) return {parameters.track(name), &node, key, known};
    Section section(*table, key, parameters.mistakes());
    Range range = known;
    range.least = section.number("min", -1e30, 1e30).value_or(range.least);
    range.most = section.number("max", -1e30, 1e30).value_or(range.most);
    const toml::node* value = section.find("default");
    const auto source = section.track("default");
    if (!value) section.find("ease"); // of keys, which may be what is missing
    section.refuse_rest();
    if (!value) {
        section.tell("needs a default, or keys = [[t, value], ...]");
    } else if (range.least > range.most) {
        section.tell(fmt::format("min = {} is above max = {}", range.least, range.most));
    } else if (const auto number = value->value<double>();
               value->is_number() && number && !range.contains(*number)) {
        section.tell("default",
                     fmt::format("must be from min = {} to max = {}", range.least, range.most));
    }
    return {source, &node, key, range};
}

// Parameters in the order of first mention: the catalogue's, then the scene's own.
void read_parameters(Section& sections, SurfaceParts& parts, TrackTable& tracks) {
    std::map<std::string, Parameter> found;
    const bool has_arrays =
        sections.has("arrays") || (parts.catalogue && parts.catalogue->contains("arrays"));
    const auto read = [&](Section& from) {
        auto section = from.section("parameters");
        if (!section) return;
        // toml++ keeps tables sorted by key: the order is the same for every run.
        for (const std::string& name : section->names()) {
            const toml::node& node = *section->find(name);
            section->attempt(
                name, [&] { check_parameter_name(name, node, section->dotted(name), has_arrays); });
            if (section->is_wrong(name)) continue;
            if (parts.parameters.size() == std::size_t(limits::parameters) && !found.count(name)) {
                section->tell(name,
                              fmt::format("is one too many: a scene has at most {} parameters",
                                          limits::parameters));
                return;
            }
            if (!found.count(name)) parts.parameters.push_back(name);
            found[name] = read_parameter(*section, name, found[name].range);
        }
    };
    if (parts.catalogue) {
        Section catalogue(*parts.catalogue, "", sections.mistakes());
        read(catalogue);
    }
    read(sections);
    for (const std::string& name : parts.parameters) {
        tracks.add(name, found[name].source, stand_in_number, found[name].node);
        tracks.place(name, found[name].key, found[name].node);
        parts.surface.ranges.push_back(found[name].range);
    }
}

// The track of a field that has one value for all elements.
animation::TrackSource as_track(const animation::FieldSource& source) {
    if (const auto* number = std::get_if<double>(&source)) return *number;
    return std::get<animation::Expression>(source);
}

// Fields with one value for all elements become parameters: read once, not once an element.
void make_vocabulary(SurfaceParts& parts, TrackTable& tracks, MistakeList& mistakes) {
    parts.vocabulary.parameters = parts.parameters;
    for (const animation::Array& array : parts.arrays) {
        formula::ArrayName names{array.name, {}};
        for (std::size_t f = 0; f < array.fields.size(); ++f) {
            const animation::ArrayField& field = array.fields[f];
            formula::FieldName name{field.name, {}};
            if (animation::stands_alone(array, f)) {
                const std::string track = array.name + "." + field.name;
                name.parameter =
                    tracks.add(track, as_track(field.source), stand_in_number, nullptr);
                parts.vocabulary.parameters.push_back(track);
            }
            names.fields.push_back(name);
        }
        parts.vocabulary.arrays.push_back(names);
    }
    parts.own_arrays = parts.arrays.size();
    // The time, in a formula that names it.
    if (parts.formula && names_time(*parts.formula)) {
        tracks.add("t", animation::Expression{"t"}, 0, nullptr);
        parts.vocabulary.parameters.emplace_back("t");
    }
    parts.surface.parameters = tracks.size();
    if (tracks.size() > limits::parameters) {
        mistakes.attempt([&] {
            tracks.fail_at(
                parts.vocabulary.parameters.back(),
                fmt::format("is one too many: parameters, and fields with one value for all "
                            "elements, are at most {} together",
                            limits::parameters));
        });
    }
}

toml::table catalogue_document(const toml::node& use, const std::string& key,
                               const std::string& name) {
    const auto file = surface_file(name);
    // A bare name: no path to somewhere else.
    std::error_code ignored;
    if (name.find_first_of(std::string_view("/\0", 2)) != name.npos ||
        !std::filesystem::exists(file, ignored)) {
        const auto known = surface_names();
        const std::string near = base::nearest_name(name, known);
        fail(use, key,
             near.empty()
                 ? fmt::format("there is no surface '{}'; known: {}", name, fmt::join(known, ", "))
                 : fmt::format("there is no surface '{}'; did you mean '{}'?", name, near));
    }
    return read_document(file);
}

void read_catalogue(const toml::node& use, const std::string& name, SurfaceParts& parts,
                    Section& section) {
    parts.surface.name = name;
    parts.catalogue = catalogue_document(use, section.dotted("use"), name);
    parts.formula_key = "formula";
    Section catalogue(*parts.catalogue, "", section.mistakes());
    for (const char* known :
         {"title", "source", "bounds", "parameters", "arrays", "isolation", "material"}) {
        catalogue.find(known);
    }
    parts.formula_node = catalogue.find("formula");
    if (parts.formula_node) {
        parts.formula = catalogue.text("formula");
    } else {
        catalogue.tell_missing("formula", "the left side of F = 0");
    }
    catalogue.refuse_rest();
}

// The key of a scene that --set would need its section for; empty for other names, and for those of
// several sections.
std::string key_called(const std::string& name) {
    std::vector<std::string> called;
    for (const SectionDescription& section : key_sections()) {
        for (const KeyDescription& key : section.keys) {
            if (key.name == name) called.push_back(section.name + "." + name);
        }
    }
    return called.size() == 1 ? called.front() : "";
}

// Everything that a surface is drawn by.
std::vector<const formula::Graph*> graphs_of(const SurfaceParts& parts,
                                             std::span<const formula::Paint* const> paints) {
    std::vector<const formula::Graph*> graphs{&parts.surface.field->graph};
    for (const formula::Paint* paint : paints) graphs.push_back(&paint->graph);
    return graphs;
}

// A field that neither the formula nor a sibling names is a slip of the pen, as with parameters:
// "weigth = 2" would leave the catalogue's weight as it was. `used` is that of the vocabulary's
// parameters. An array that the formula leaves out altogether is no slip.
void refuse_unused_fields(const SurfaceParts& parts, std::span<const formula::Graph* const> graphs,
                          const std::vector<bool>& used, const TrackTable& tracks,
                          MistakeList& mistakes) {
    const animation::Animation& animation = parts.surface.animation;
    for (std::size_t a = 0; a < parts.arrays.size(); ++a) {
        const animation::Array& array = parts.arrays[a];
        std::vector<bool> in_formula(array.fields.size(), false);
        for (const formula::Graph* graph : graphs) {
            for (formula::NodeId id = 0; id < graph->size(); ++id) {
                const formula::Node& node = (*graph)[id];
                if (node.op == formula::Op::element && std::size_t(node.index) == a)
                    in_formula[std::size_t(node.second)] = true;
            }
        }
        std::vector<std::string> names;
        for (std::size_t f = 0; f < array.fields.size(); ++f) {
            const auto& parameter = parts.vocabulary.arrays[a].fields[f].parameter;
            if (parameter && used[std::size_t(*parameter)]) in_formula[f] = true;
            names.push_back(array.fields[f].name);
        }
        if (std::none_of(in_formula.begin(), in_formula.end(), [](bool in) { return in; }))
            continue;
        for (std::size_t f = 0; f < array.fields.size(); ++f) {
            if (in_formula[f] || animation.is_referenced(a, f)) continue;
            // Simulations write more columns than a formula reads.
            if (std::holds_alternative<animation::Column>(array.fields[f].source)) continue;
            std::vector<std::string> others = names;
            others.erase(others.begin() + std::ptrdiff_t(f));
            const std::string near = base::nearest_name(names[f], others);
            mistakes.attempt([&] {
                tracks.fail_at(
                    array.name + "." + names[f],
                    near.empty()
                        ? "neither the formula nor another field uses this field"
                        : fmt::format("nothing uses this field; did you mean '{}'?", near));
            });
        }
    }
}

// Reads [surface] but for its bounds and its transform.
void read_formula(Section& section, SurfaceParts& parts) {
    read_keys(keys::surface_keys, section, parts.surface);
    for (const char* read_later : {"bounds", "transform"}) section.find(read_later);
    const toml::node* use = section.find("use");
    const toml::node* formula = section.find("formula");
    parts.formula_key = section.dotted("formula");
    parts.bounds_key = section.dotted("bounds");
    if (use && formula) {
        section.tell("formula", "the surface has `use` already; keep one");
    } else if (use) {
        if (const auto name = section.text("use"))
            section.attempt("use", [&] { read_catalogue(*use, *name, parts, section); });
    } else if (formula) {
        parts.formula_node = formula;
        parts.formula = section.text("formula");
    } else if (section.refuse_rest()) { // no slip of the pen
        section.tell("needs formula = \"...\", or use = \"name\" of the catalogue");
    }
}

// An array of terms that the formula repeats. No formula can name it.
void add_terms(formula::ElementNumbers numbers, SurfaceParts& parts, TrackTable& tracks) {
    const auto before = std::ranges::count_if(parts.arrays, &animation::Array::is_of_formula);
    const std::string name = fmt::format("terms {}", before + 1);
    tracks.place(name + ".count", parts.formula_key, parts.formula_node);
    animation::Array array{name, int(numbers.front().size()), {}};
    array.is_of_formula = true;
    formula::ArrayName names{name, {}};
    for (std::vector<double>& column : numbers) {
        const std::string field = fmt::format("number {}", array.fields.size() + 1);
        tracks.place(name + "." + field, parts.formula_key, parts.formula_node);
        array.fields.push_back({field, std::move(column)});
        names.fields.push_back({field, {}});
    }
    parts.arrays.push_back(std::move(array));
    parts.vocabulary.arrays.push_back(std::move(names));
}

} // namespace

std::unique_ptr<SurfaceParts> read_surface(Section& section, Section& sections,
                                           const animation::Timeline& timeline, TrackTable& tracks,
                                           const base::Confines& within, Surface& surface) {
    auto parts = std::make_unique<SurfaceParts>(surface);
    MistakeList& mistakes = section.mistakes();
    read_formula(section, *parts);
    read_parameters(sections, *parts, tracks);
    std::optional<Section> catalogue;
    if (const auto& table = parts->catalogue) catalogue.emplace(*table, "", mistakes);
    parts->are_arrays_known = read_arrays(catalogue ? &*catalogue : nullptr, sections, timeline,
                                          tracks, within, parts->arrays);
    make_vocabulary(*parts, tracks, mistakes);
    return parts;
}

bool make_field(SurfaceParts& parts, TrackTable& tracks, MistakeList& mistakes) {
    if (!parts.are_arrays_known) return false;
    parts.arrays.resize(parts.own_arrays);
    parts.vocabulary.arrays.resize(parts.own_arrays);
    std::vector<formula::ElementNumbers> repeated;
    const auto make = [&](const std::string& formula) {
        parts.surface.field = std::make_shared<formula::Field>(
            formula::make_field(formula, parts.vocabulary, &repeated, parts.origin));
    };
    const bool is_right = parts.formula && mistakes.attempt([&] {
        try {
            make(*parts.formula);
        } catch (const formula::ParseError& error) {
            fail(*parts.formula_node, parts.formula_key, error.what());
        } catch (const std::length_error& error) {
            fail(*parts.formula_node, parts.formula_key, error.what());
        }
    });
    if (!is_right) make("x");
    for (formula::ElementNumbers& numbers : repeated) add_terms(std::move(numbers), parts, tracks);
    return is_right;
}

void store_elements_of(SurfaceParts& parts, std::span<const formula::Paint* const> paints) {
    if (paints.empty()) return;
    formula::Field field = *parts.surface.field;
    for (const formula::Paint* paint : paints)
        field = formula::with_elements_of(std::move(field), paint->value);
    parts.surface.field = std::make_shared<formula::Field>(std::move(field));
}

void refuse_unused(const SurfaceParts& parts, std::span<const formula::Paint* const> paints,
                   const TrackTable& tracks, std::set<std::string>* for_others,
                   MistakeList& mistakes) {
    std::vector<bool> used(parts.vocabulary.parameters.size(), false);
    const auto graphs = graphs_of(parts, paints);
    for (const formula::Graph* graph : graphs) {
        for (formula::NodeId id = 0; id < graph->size(); ++id) {
            const formula::Node& node = (*graph)[id];
            if (node.op == formula::Op::parameter) used[std::size_t(node.index)] = true;
        }
    }
    refuse_unused_fields(parts, graphs, used, tracks, mistakes);
    // A parameter that neither the formula nor an expression names is a slip of the pen.
    for (std::size_t k = 0; k < parts.parameters.size(); ++k) {
        if (used[k] || parts.surface.animation.is_referenced(int(k))) {
            if (for_others) for_others->erase(parts.parameters[k]);
            continue;
        }
        if (for_others && for_others->contains(parts.parameters[k])) continue;
        std::vector<std::string> others = parts.parameters;
        others.erase(others.begin() + std::ptrdiff_t(k));
        const std::string& name = parts.parameters[k];
        const std::string near = base::nearest_name(name, others);
        const std::string key = key_called(name);
        mistakes.attempt([&] {
            tracks.fail_at(
                name, !key.empty() ? fmt::format("nothing uses this parameter; did you mean the "
                                                 "scene's key {}?",
                                                 key)
                      : near.empty()
                          ? "neither the formula nor an expression uses this parameter"
                          : fmt::format("nothing uses this parameter; did you mean '{}'?", near));
        });
    }
}

} // namespace isomotion::scene
