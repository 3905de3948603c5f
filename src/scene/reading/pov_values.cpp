#include "scene/reading/pov_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "formula/graph/vocabulary.h"
#include "scene/limits.h"
#include "scene/reading/pov_colors.h"
#include "scene/reading/pov_functions.h"
#include "scene/reading/toml_lines.h"
#include "scene/srgb.h"

namespace isomotion::scene {
namespace {

using Strength = PovNumber::Strength;

std::string held(const PovNumber& number, Strength least) {
    return number.strength < least ? fmt::format("({})", number.text) : number.text;
}

// Part by part; a single number goes with every part.
PovValue joined(const PovValue& a, char sign, const PovValue& b) {
    PovValue all;
    const std::size_t size = std::max(a.size(), b.size());
    for (std::size_t k = 0; k < size; ++k) {
        if ((k >= a.size() && a.size() > 1) || (k >= b.size() && b.size() > 1)) break;
        all.push_back(joined(a.size() > 1 ? a[k] : a[0], sign, b.size() > 1 ? b[k] : b[0]));
    }
    return all;
}

// Whether formulas have the name already: a number declared by it stays a number.
bool is_taken(const std::string& name) {
    return !formula::is_identifier(name) || name.size() > limits::name_bytes ||
           formula::is_reserved(name) || is_pov_word_of_formulas(name) || name == "t" ||
           name == "i" || name == "n" || name == "clock";
}

PovNumber word_of(const char* text) { return {text, Strength::atom, std::nullopt}; }

// Where a comma was left out, as POV-Ray allows.
bool is_value_ahead(const PovWord& word) {
    return word.kind == PovWord::Kind::number || word.kind == PovWord::Kind::name || word.is("(");
}

} // namespace

PovNumber joined(const PovNumber& a, char sign, const PovNumber& b) {
    std::optional<double> value;
    if (a.value && b.value) {
        switch (sign) {
        case '+':
            value = *a.value + *b.value;
            break;
        case '-':
            value = *a.value - *b.value;
            break;
        case '*':
            value = *a.value * *b.value;
            break;
        case '/':
            value = *a.value / *b.value;
            break;
        default:
            value = std::pow(*a.value, *b.value);
            break;
        }
        if (!std::isfinite(*value)) value.reset();
    }
    if (value && a.is_plain() && b.is_plain()) return PovNumber::of(*value);
    // Parts of "360*clock*y" that are 0, and the other.
    const auto is = [](const PovNumber& n, double wanted) {
        return n.is_plain() && n.value == wanted;
    };
    if (sign == '*' && (is(a, 0) || is(b, 0))) return PovNumber::of(0);
    if ((sign == '*' && is(a, 1)) || (sign == '+' && is(a, 0))) return b;
    if (((sign == '*' || sign == '/') && is(b, 1)) || ((sign == '+' || sign == '-') && is(b, 0)))
        return a;
    const bool is_sum = sign == '+' || sign == '-';
    const bool is_power = sign == '^';
    const Strength own = is_sum ? Strength::sum : is_power ? Strength::power : Strength::product;
    const Strength left = is_power ? Strength::atom : own;
    const Strength right = is_sum ? Strength::product : is_power ? Strength::atom : Strength::power;
    const std::string between = is_sum ? fmt::format(" {} ", sign) : std::string(1, sign);
    return {held(a, left) + between + held(b, right), own, value};
}

PovNumber PovNumber::of(double value) {
    // A sign would bind less than what comes before it.
    return {fmt::format("{}", value), value < 0 ? Strength::sum : Strength::atom, value};
}

std::optional<glm::dvec3> still_vector(const PovValue& parts) {
    const auto &x = parts[0].value, &y = parts[1].value, &z = parts[2].value;
    if (!x || !y || !z) return std::nullopt;
    return glm::dvec3(*x, *y, *z);
}

std::optional<double> PovNumber::plain() const {
    return value && text == of(*value).text ? value : std::nullopt;
}

bool PovValues::is_color(const PovWord& word) const {
    return is_pov_color_word(word.text) || pov_color(word.text) || word.is("<") ||
           (word.kind == PovWord::Kind::name && known(word.text));
}

bool PovValues::declare(const std::string& name, PovCursor& at) {
    const std::size_t line = at.now().line;
    if (at.now().is("function")) {
        at.take();
        declare_function(name, at);
        return true;
    }
    const PovWord& word = at.now();
    const bool is_value = word.kind == PovWord::Kind::number || word.kind == PovWord::Kind::sign ||
                          is_color(word) || is_pov_function(word.text) || word.is("pi") ||
                          word.is("clock") || word.is("x") || word.is("y") || word.is("z");
    if (!is_value) return false;
    PovValue declared = value(at, "#declare " + name);
    at.take_if(";");
    // Counters would name one another in a long chain: numbers that stand still are computed.
    const auto again = values_.find(name);
    const bool counts = again != values_.end() && again->second.size() > 1;
    const std::optional<double> still = declared.size() == 1 ? declared[0].value : std::nullopt;
    if (counts && still) {
        declared[0] = PovNumber::of(*still);
    } else if (declared.size() == 1 && !is_taken(name)) {
        const std::string parameter = parameter_of(name);
        parameters_.push_back({parameter, declared[0].text, line});
        declared[0].text = parameter;
        declared[0].strength = Strength::atom;
    }
    declare(name, std::move(declared), at);
    return true;
}

// What was read before keeps the value that the name had then.
void PovValues::declare(const std::string& name, PovValue value, const PovCursor& at) {
    if (++meaning_.declared > most_declared)
        at.fail("#declare " + name, fmt::format("more than {} values", most_declared));
    values_[name].push_back({meaning_.declared, std::move(value)});
}

void PovValues::forget(const std::string& name) {
    if (known(name)) values_[name].push_back({++meaning_.declared, {}});
}

// A name that is declared again is another parameter.
std::string PovValues::parameter_of(const std::string& name) {
    std::string parameter = name;
    for (int times = 2;
         parameter_names_.contains(parameter) || (parameter != name && values_.contains(parameter));
         ++times)
        parameter = fmt::format("{}_{}", name, times);
    parameter_names_.insert(parameter);
    return parameter;
}

const PovValue* PovValues::known(const std::string& name) const {
    const auto found = values_.find(name);
    if (found == values_.end()) return nullptr;
    const auto later =
        std::ranges::upper_bound(found->second, meaning_.declared, {}, &Declared::when);
    if (later == found->second.begin() || std::prev(later)->value.empty()) return nullptr;
    return &std::prev(later)->value;
}

const PovValues::Function* PovValues::known_function(const std::string& name) const {
    const auto found = functions_.find(name);
    if (found == functions_.end()) return nullptr;
    // Its own body knows only what was there before it.
    const auto later =
        std::ranges::lower_bound(found->second, meaning_.declared, {}, &Function::declared);
    return later == found->second.begin() ? nullptr : &*std::prev(later);
}

void PovValues::declare_function(const std::string& name, PovCursor& at) {
    Function function{{"x", "y", "z"}, 0, meaning_.declared};
    if (at.take_if("(")) {
        function.arguments.clear();
        while (!at.now().is(")")) {
            if (at.now().kind != PovWord::Kind::name) at.fail(name, "needs names as arguments");
            function.arguments.push_back(at.take().text);
            at.take_if(",");
        }
        at.take();
    }
    const std::size_t open = at.place();
    if (!at.now().is("{")) at.fail(name, "needs { before its expression");
    at.skip_group(name);
    at.take_if(";");
    function.body = open + 1;
    ++meaning_.declared;
    functions_[name].push_back(std::move(function));
}

PovValue PovValues::value(PovCursor& at, std::string_view for_what) {
    for_what_ = for_what;
    return sum(at);
}

PovNumber PovValues::number(PovCursor& at, std::string_view for_what) {
    const std::size_t place = at.place();
    PovValue read = value(at, for_what);
    if (read.size() != 1) {
        at.go_to(place);
        at.fail(for_what, "must be a number here, not a vector");
    }
    return read[0];
}

std::vector<PovNumber> PovValues::vector(PovCursor& at, std::string_view for_what) {
    const std::size_t place = at.place();
    PovValue read = value(at, for_what);
    if (read.size() == 1) read.resize(3, read[0]);
    if (read.size() < 3) {
        at.go_to(place);
        at.fail(for_what, "must be a vector of three numbers: <1, 2, 3>");
    }
    read.resize(3); // filter and transmit of colours
    return read;
}

double PovValues::constant(PovCursor& at, std::string_view for_what) {
    const PovNumber read = number(at, for_what);
    if (!read.value) at.fail(for_what, "must be a number that does not move");
    return *read.value;
}

PovNumber PovValues::function(PovCursor& at) {
    at.expect("{", "function");
    const Arguments coordinates{{"x", word_of("x")}, {"y", word_of("z")}, {"z", word_of("y")}};
    PovNumber body;
    {
        const Meaning within(*this, {&coordinates, meaning_.declared});
        body = number(at, "function");
    }
    at.expect("}", "function");
    return body;
}

void PovValues::expect_short(const PovValue& value, const PovCursor& at) const {
    if (value[0].text.size() > longest_pov_text) at.fail(for_what_, "is too long a formula");
}

PovValue PovValues::sum(PovCursor& at) {
    const PovDepth within(depth_, at, for_what_);
    PovValue all = product(at);
    while (at.now().is("+") || at.now().is("-")) {
        const char sign = at.take().text[0];
        all = joined(all, sign, product(at));
        expect_short(all, at);
    }
    return all;
}

PovValue PovValues::product(PovCursor& at) {
    PovValue all = signed_value(at);
    while (at.now().is("*") || at.now().is("/")) {
        const char sign = at.take().text[0];
        all = joined(all, sign, signed_value(at));
        expect_short(all, at);
    }
    return all;
}

PovValue PovValues::signed_value(PovCursor& at) {
    bool is_negative = false;
    for (; at.now().is("-") || at.now().is("+"); at.take()) is_negative ^= at.now().is("-");
    PovValue all = power(at);
    if (!is_negative) return all;
    for (PovNumber& part : all) {
        if (part.is_plain()) {
            part = PovNumber::of(-*part.value);
        } else {
            part.text = "-" + held(part, Strength::power);
            part.strength = Strength::sum;
            if (part.value) part.value = -*part.value;
        }
    }
    return all;
}

PovValue PovValues::power(PovCursor& at) {
    PovValue base = part(at);
    if (!at.take_if("^")) return base;
    const PovDepth within(depth_, at, for_what_);
    return joined(base, '^', signed_value(at));
}

PovValue PovValues::list(PovCursor& at) {
    PovValue all;
    do {
        PovValue one = sum(at);
        if (one.size() != 1) at.fail(for_what_, "must have numbers as the parts of a vector");
        all.push_back(one[0]);
    } while (at.take_if(",") || (!at.now().is(">") && is_value_ahead(at.now())));
    at.expect(">", for_what_);
    return all;
}

PovValue PovValues::part(PovCursor& at) {
    if (at.now().kind == PovWord::Kind::number) return {PovNumber::of(at.take().number)};
    PovValue read;
    if (at.take_if("(")) {
        read = sum(at);
        at.expect(")", for_what_);
    } else if (at.take_if("<")) {
        read = list(at);
    } else if (at.now().kind == PovWord::Kind::name) {
        read = named(at);
    } else {
        at.fail(for_what_,
                fmt::format("needs a number, a vector or a name before '{}'", at.now().text));
    }
    while (at.now().is(".") && read.size() > 1) {
        at.take();
        static constexpr std::string_view parts[] = {"x", "y", "z", "red", "green", "blue"};
        const auto found = std::ranges::find(parts, at.now().text) - std::begin(parts);
        if (found == std::ssize(parts) || std::size_t(found % 3) >= read.size())
            at.fail(for_what_, "has parts .x, .y and .z");
        at.take();
        read = {read[std::size_t(found % 3)]};
    }
    return read;
}

// After "color" or on their own: red 1 green 0.5, each part that is left out 0; or rgb <...>.
PovValue PovValues::color(PovCursor& at) {
    const PovDepth within(depth_, at, for_what_);
    const std::string name = at.now().text;
    if (pov_color_part(name) >= 0) {
        PovValue parts(5, PovNumber::of(0));
        for (int part = 0; (part = pov_color_part(at.now().text)) >= 0;) {
            at.take();
            const PovValue one = sum(at);
            if (one.size() != 1) at.fail(for_what_, "needs one number as a part of a colour");
            parts[std::size_t(part)] = one[0];
        }
        return parts;
    }
    at.take();
    const bool is_any = name == "color" || name == "colour";
    PovValue read = is_any ? signed_value(at) : part(at);
    // One number stands for all parts.
    if (read.size() == 1) read.resize(is_any || name == "rgb" || name == "srgb" ? 3 : 4, read[0]);
    if (name == "rgbt" && read.size() == 4) read.insert(read.begin() + 3, PovNumber::of(0));
    if (name != "srgb") return read;
    const auto still = read.size() < 3 ? std::nullopt : still_vector(read);
    if (!still) at.fail("srgb", "needs three numbers that do not move");
    const glm::dvec3 linear = to_linear(*still);
    return {PovNumber::of(linear.x), PovNumber::of(linear.y), PovNumber::of(linear.z)};
}

PovValue PovValues::named(PovCursor& at) {
    const std::string name = at.now().text;
    if (!meaning_.arguments && is_pov_color_word(name)) return color(at);
    if (meaning_.arguments) {
        if (const auto found = meaning_.arguments->find(name); found != meaning_.arguments->end()) {
            at.take();
            return {found->second};
        }
    }
    if (at.next().is("(")) {
        if (known_function(name)) return {call_declared(at, name)};
        return call(at, name);
    }
    at.take();
    if (const PovValue* value = known(name)) return *value;
    const PovNumber zero = PovNumber::of(0), one = PovNumber::of(1);
    if (!meaning_.arguments && name == "x") return {one, zero, zero};
    if (!meaning_.arguments && name == "y") return {zero, one, zero};
    if (!meaning_.arguments && name == "z") return {zero, zero, one};
    if (name == "pi") return {PovNumber{"pi", Strength::atom, std::numbers::pi}};
    if (name == "clock") return {word_of("clock")};
    if (name == "on" || name == "yes" || name == "true") return {one};
    if (name == "off" || name == "no" || name == "false") return {zero};
    if (name == "image_width") return {PovNumber::of(640)};
    if (name == "image_height") return {PovNumber::of(480)};
    if (const auto color = pov_color(name)) {
        PovValue parts;
        for (const double part : *color) parts.push_back(PovNumber::of(part));
        if ((*color)[3] == 0) parts.pop_back();
        return parts;
    }
    std::vector<std::string> names;
    for (const auto& [declared, values] : values_)
        if (names.size() < most_pov_names && known(declared)) names.push_back(declared);
    const std::string near = base::nearest_name(name, names);
    at.fail(for_what_, near.empty() ? fmt::format("'{}' is not declared before", name)
                                    : fmt::format("'{}' is not declared before; did you mean '{}'?",
                                                  name, near));
}

PovValue PovValues::call(PovCursor& at, const std::string& name) {
    const std::string refusal = pov_function_refusal(name);
    if (!refusal.empty()) at.fail(for_what_, refusal);
    at.take();
    at.take();
    std::vector<PovNumber> arguments;
    while (!at.now().is(")")) {
        PovValue one = sum(at);
        if (one.size() != 1) at.fail(for_what_, name + " takes numbers");
        arguments.push_back(one[0]);
        if (!at.take_if(",")) break;
    }
    at.expect(")", name);
    const auto called = called_pov_function(name, arguments);
    if (!called) {
        at.fail(for_what_, fmt::format("{} takes {}, not {}", name, pov_function_arguments(name),
                                       arguments.size()));
    }
    return {*called};
}

PovNumber PovValues::call_declared(PovCursor& at, const std::string& name) {
    const PovDepth within(depth_, at, for_what_);
    const Function& function = *known_function(name);
    at.take();
    at.take();
    Arguments given;
    for (std::size_t k = 0; k < function.arguments.size(); ++k) {
        if (k > 0) at.expect(",", name);
        PovValue one = sum(at);
        if (one.size() != 1) at.fail(name, "takes numbers");
        given[function.arguments[k]] = one[0];
    }
    at.expect(")", name);
    if (++calls_ > most_calls) at.fail(for_what_, fmt::format("more than {} calls", most_calls));
    const std::size_t behind = at.place();
    const Meaning there(*this, {&given, function.declared});
    at.go_to(function.body);
    const PovValue body = sum(at);
    if (body.size() != 1 || !at.now().is("}")) at.fail(name, "must be one number");
    at.go_to(behind);
    return body[0];
}

} // namespace isomotion::scene
