#include "scene/reading/mathmod_values.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/printable.h"
#include "formula/graph/functions.h"
#include "formula/graph/vocabulary.h"
#include "scene/reading/mathmod_parser.h"

namespace isomotion::scene::mathmod {
namespace {

using Meaning = Values::Meaning;

struct HelperText {
    const char *name, *arguments, *text;
};

constexpr HelperText helpers[] = {
    {"signed_power", "(u, v)", "sign(u)*abs(u)^v"},
    {"remainder", "(u, v)", "u - v*trunc(u/v)"},
    {"arcosh", "(u)", "if(u >= 1, acosh(u), log(u - 1))"}, // no value below 1
};

// Words of formulas, and of expressions over time.
constexpr std::string_view words[] = {"and", "or", "not", "if", "t", "i", "n"};

Scope scope_of_place(const Values& values) {
    return {&values,
            {{"x", input_part(Part::x, "x")},
             {"y", input_part(Part::y, "y")},
             {"z", input_part(Part::z, "z")},
             {"t", input_part(Part::t, values.time())}}};
}

} // namespace

std::string Part::condition() const {
    return is_condition ? text : fmt::format("abs({}) >= 0.5", text);
}

Part number_part(double value) {
    Part part;
    part.text = fmt::format("{}", value);
    part.value = value;
    part.is_never_negative = value >= 0;
    if (value < 0) part.strength = Part::Strength::sum;
    return part;
}

Part input_part(Part::Input input, const std::string& text) {
    Part part;
    part.text = text;
    part.inputs.set(input);
    return part;
}

Values::Values() {
    taken_.insert(time_);
    for (const HelperText& helper : helpers) {
        Part part;
        part.text = helper.text;
        define(helper.name, std::move(part));
        definitions_.back().arguments = helper.arguments;
    }
}

std::string Values::free_name(const std::string& name) {
    std::string free = name;
    while (formula::is_reserved(free) || formula::find_function(free) ||
           std::ranges::count(words, free) > 0 || taken_.contains(free))
        free += '_';
    taken_.insert(free);
    return free;
}

std::size_t Values::define(const std::string& name, Part part) {
    definitions_.push_back({free_name(name), "", std::move(part)});
    return definitions_.size() - 1;
}

void Values::add_constant(const std::string& name, std::string_view text, const JsonPlace& at) {
    const Scope scope{this, {}, false, false};
    const Part part = parsed(text, scope, at);
    if (!part.value)
        at.fail(fmt::format("'{}' must be a number that does not depend on sliders", name));
    if (!std::isfinite(*part.value)) at.fail(fmt::format("'{}' has no finite value", name));
    const std::size_t k = define(name, number_part(*part.value));
    Part named = definitions_[k].part;
    named.text = definitions_[k].name;
    named.strength = Part::Strength::atom;
    named.names = {k};
    meanings_[name] = {Meaning::Kind::part, std::move(named), 0};
}

void Values::add_slider(const std::string& name, double value) {
    // A constant of this name is not named from now on.
    const auto constant = meanings_.find(name);
    if (constant != meanings_.end() && !constant->second.part.names.empty()) {
        Definition& definition = definitions_[*constant->second.part.names.begin()];
        taken_.erase(definition.name);
        definition.name.clear();
    }
    Part part;
    part.text = free_name(name);
    part.parameters = {part.text};
    sliders_[part.text] = value;
    meanings_[name] = {Meaning::Kind::part, std::move(part), 0};
}

void Values::add_variable(const std::string& name, std::string_view text, const JsonPlace& at) {
    const Scope scope{
        this, {{"u", input_part(Part::u, "u")}, {"tm", input_part(Part::t, time_)}}, false};
    const std::size_t k = define(name, parsed(text, scope, at));
    Definition& definition = definitions_[k];
    const bool depends = definition.part.inputs.test(Part::u);
    if (depends) definition.arguments = "(u)";
    for (const auto& [axis, input] : {std::pair("x", Part::x), {"y", Part::y}, {"z", Part::z}}) {
        Part named = definition.part;
        named.text = depends ? fmt::format("{}({})", definition.name, axis) : definition.name;
        named.strength = Part::Strength::atom;
        named.is_condition = false;
        named.names = {k};
        named.parameters.clear();
        named.depth = 1;
        named.inputs.reset(Part::u);
        named.inputs.set(input, depends);
        meanings_[name + axis] = {Meaning::Kind::part, std::move(named), 0};
    }
}

void Values::add_function(const std::string& name, std::string_view text, const JsonPlace& at) {
    const std::size_t k = define(name, parsed(text, scope_of_place(*this), at));
    Definition& definition = definitions_[k];
    const std::array<std::pair<Part::Input, std::string>, 4> inputs{
        {{Part::x, "x"}, {Part::y, "y"}, {Part::z, "z"}, {Part::t, time_}}};
    for (const auto& [input, argument] : inputs) {
        if (!definition.part.inputs.test(input)) continue;
        definition.arguments += definition.arguments.empty() ? "(" : ", ";
        definition.arguments += argument;
    }
    if (!definition.arguments.empty()) definition.arguments += ')';
    meanings_[name] = {Meaning::Kind::function, {}, k};
}

Part Values::formula(std::string_view text, const JsonPlace& at) const {
    return parsed(text, scope_of_place(*this), at);
}

Part Values::limit(std::string_view text, const JsonPlace& at) const {
    const Scope scope{this, {{"t", input_part(Part::t, "t")}}, false, false};
    Part part = parsed(text, scope, at);
    if (part.value && !std::isfinite(*part.value)) at.fail("has no finite value");
    return part;
}

std::vector<bool> Values::needed_for(const Part& part) const {
    std::vector<bool> needed(definitions_.size());
    for (const std::size_t k : part.names) needed[k] = true;
    for (std::size_t k = definitions_.size(); k-- > 0;) {
        if (!needed[k]) continue;
        for (const std::size_t before : definitions_[k].part.names) needed[before] = true;
    }
    return needed;
}

std::set<std::string> Values::parameters_of(const Part& part) const {
    std::set<std::string> all = part.parameters;
    const std::vector<bool> needed = needed_for(part);
    for (std::size_t k = 0; k < definitions_.size(); ++k) {
        const auto& own = definitions_[k].part.parameters;
        if (needed[k]) all.insert(own.begin(), own.end());
    }
    return all;
}

std::string Values::definitions_for(const Part& part) const {
    const std::vector<bool> needed = needed_for(part);
    std::string text;
    for (std::size_t k = 0; k < definitions_.size(); ++k) {
        const Definition& one = definitions_[k];
        if (needed[k]) text += fmt::format("{}{} = {}; ", one.name, one.arguments, one.part.text);
    }
    return text;
}

} // namespace isomotion::scene::mathmod
