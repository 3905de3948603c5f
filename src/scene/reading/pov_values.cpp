#include "scene/reading/pov_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "formula/graph/vocabulary.h"
#include "scene/limits.h"
#include "scene/reading/toml_lines.h"

namespace isomotion::scene {
namespace {

using Strength = PovNumber::Strength;

constexpr int deepest = 60; // parentheses and calls in one another
constexpr std::size_t longest_text = 500'000;

std::string held(const PovNumber& number, Strength least) {
    return number.strength < least ? fmt::format("({})", number.text) : number.text;
}

// Plain numbers are computed here, others are left to the formula.
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

struct Known {
    const char* name;
    std::size_t arguments;
    const char* text; // with {0}, {1}; of one argument of the same name, as it is
    double (*value)(double);
};

constexpr Known known_functions[] = {
    {"abs", 1, "abs({0})", std::fabs},
    {"acos", 1, "acos({0})", std::acos},
    {"acosh", 1, "acosh({0})", std::acosh},
    {"asin", 1, "asin({0})", std::asin},
    {"asinh", 1, "asinh({0})", std::asinh},
    {"atan", 1, "atan({0})", std::atan},
    {"atan2", 2, "atan2({0}, {1})", nullptr},
    {"ceil", 1, "(-floor(-({0})))", std::ceil},
    {"cos", 1, "cos({0})", std::cos},
    {"cosh", 1, "cosh({0})", std::cosh},
    {"degrees", 1, "(({0})*180/pi)", [](double a) { return a * 180 / std::numbers::pi; }},
    {"exp", 1, "exp({0})", std::exp},
    {"floor", 1, "floor({0})", std::floor},
    {"ln", 1, "log({0})", std::log},
    {"log", 1, "(log({0})/log(10))", std::log10},
    {"pow", 2, "({0})^({1})", nullptr},
    {"radians", 1, "(({0})*pi/180)", [](double a) { return a * std::numbers::pi / 180; }},
    {"sin", 1, "sin({0})", std::sin},
    {"sinh", 1, "sinh({0})", std::sinh},
    {"sqr", 1, "({0})^2", [](double a) { return a * a; }},
    {"sqrt", 1, "sqrt({0})", std::sqrt},
    {"tan", 1, "tan({0})", std::tan},
    {"tanh", 1, "tanh({0})", std::tanh},
    // functions.inc has these; its y is our z.
    {"f_sphere", 4, "(sqrt(({0})^2 + ({1})^2 + ({2})^2) - ({3}))", nullptr},
    {"f_torus", 5, "(sqrt((sqrt(({0})^2 + ({2})^2) - ({3}))^2 + ({1})^2) - ({4}))", nullptr},
};

const Known* known_function(std::string_view name) {
    const auto found = std::ranges::find(known_functions, name, &Known::name);
    return found == std::end(known_functions) ? nullptr : found;
}

struct NamedColor {
    const char* name;
    double red, green, blue;
};

// colors.inc has these.
constexpr NamedColor colors[] = {
    {"White", 1, 1, 1},
    {"Black", 0, 0, 0},
    {"Red", 1, 0, 0},
    {"Green", 0, 1, 0},
    {"Blue", 0, 0, 1},
    {"Yellow", 1, 1, 0},
    {"Cyan", 0, 1, 1},
    {"Magenta", 1, 0, 1},
    {"Orange", 1, 0.5, 0},
    {"Gold", 0.8, 0.498039, 0.196078},
    {"Silver", 0.90, 0.91, 0.98},
    {"Gray", 0.752941, 0.752941, 0.752941},
    {"Grey", 0.752941, 0.752941, 0.752941},
    {"Gray50", 0.5, 0.5, 0.5},
};

const NamedColor* named_color(std::string_view name) {
    const auto found = std::ranges::find(colors, name, &NamedColor::name);
    return found == std::end(colors) ? nullptr : found;
}

bool is_color_word(std::string_view word) {
    return word == "rgb" || word == "rgbf" || word == "rgbt" || word == "rgbft" ||
           word == "color" || word == "colour" || word == "srgb";
}

// Whether formulas have the name already: a number declared by it stays a number.
bool is_taken(const std::string& name) {
    return !formula::is_identifier(name) || name.size() > limits::name_bytes ||
           formula::is_reserved(name) || name == "t" || name == "i" || name == "n" ||
           name == "clock";
}

PovNumber word_of(const char* text) { return {text, Strength::atom, std::nullopt}; }

// Counts what is being read within what.
class Depth {
public:
    Depth(int& depth, const PovCursor& at, const std::string& for_what)
        : depth_(depth) {
        if (++depth_ > deepest) {
            --depth_;
            at.fail(for_what,
                    fmt::format("more than {} parentheses and calls in one another", deepest));
        }
    }
    ~Depth() { --depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

private:
    int& depth_;
};

} // namespace

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
    return is_color_word(word.text) || named_color(word.text) || word.is("<") ||
           (word.kind == PovWord::Kind::name && values_.contains(word.text));
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
                          is_color(word) || known_function(word.text) || word.is("pi") ||
                          word.is("clock") || word.is("x") || word.is("y") || word.is("z") ||
                          word.is("min") || word.is("max");
    if (!is_value) return false;
    PovValue declared = value(at, "#declare " + name);
    at.take_if(";");
    if (declared.size() == 1 && !is_taken(name)) {
        std::erase_if(parameters_, [&](const Parameter& known) { return known.name == name; });
        parameters_.push_back({name, declared[0].text, line});
        declared[0].text = name;
        declared[0].strength = Strength::atom;
    }
    values_[name] = std::move(declared);
    return true;
}

void PovValues::declare_function(const std::string& name, PovCursor& at) {
    Function function{{"x", "y", "z"}, 0};
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
    functions_[name] = std::move(function);
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
    arguments_ = &coordinates;
    PovNumber body;
    try {
        body = number(at, "function");
    } catch (...) {
        arguments_ = nullptr;
        throw;
    }
    arguments_ = nullptr;
    at.expect("}", "function");
    return body;
}

void PovValues::expect_short(const PovValue& value, const PovCursor& at) const {
    if (value[0].text.size() > longest_text) at.fail(for_what_, "is too long a formula");
}

PovValue PovValues::sum(PovCursor& at) {
    const Depth within(depth_, at, for_what_);
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
    return joined(base, '^', signed_value(at));
}

PovValue PovValues::list(PovCursor& at) {
    PovValue all;
    do {
        PovValue one = sum(at);
        if (one.size() != 1) at.fail(for_what_, "must have numbers as the parts of a vector");
        all.push_back(one[0]);
    } while (at.take_if(","));
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

PovValue PovValues::named(PovCursor& at) {
    const std::string name = at.now().text;
    if (is_color_word(name)) {
        at.take();
        PovValue read = name == "color" || name == "colour" ? signed_value(at) : part(at);
        if (read.size() == 1) read.resize(3, read[0]);
        if (name != "srgb") return read;
        const auto still = read.size() < 3 ? std::nullopt : still_vector(read);
        if (!still) at.fail("srgb", "needs three numbers that do not move");
        const glm::dvec3 linear = to_linear(*still);
        return {PovNumber::of(linear.x), PovNumber::of(linear.y), PovNumber::of(linear.z)};
    }
    if (arguments_) {
        if (const auto found = arguments_->find(name); found != arguments_->end()) {
            at.take();
            return {found->second};
        }
    }
    if (at.next().is("(")) {
        if (functions_.contains(name)) return {call_declared(at, name)};
        return call(at, name);
    }
    at.take();
    if (const auto found = values_.find(name); found != values_.end()) return found->second;
    const PovNumber zero = PovNumber::of(0), one = PovNumber::of(1);
    if (!arguments_ && name == "x") return {one, zero, zero};
    if (!arguments_ && name == "y") return {zero, one, zero};
    if (!arguments_ && name == "z") return {zero, zero, one};
    if (name == "pi") return {PovNumber{"pi", Strength::atom, std::numbers::pi}};
    if (name == "clock") return {word_of("clock")};
    if (name == "on" || name == "yes" || name == "true") return {one};
    if (name == "off" || name == "no" || name == "false") return {zero};
    if (name == "image_width") return {PovNumber::of(640)};
    if (name == "image_height") return {PovNumber::of(480)};
    if (const NamedColor* color = named_color(name))
        return {PovNumber::of(color->red), PovNumber::of(color->green), PovNumber::of(color->blue)};
    std::vector<std::string> names;
    for (const auto& [declared, value] : values_) names.push_back(declared);
    const std::string near = base::nearest_name(name, names);
    at.fail(for_what_, near.empty() ? fmt::format("'{}' is not declared before", name)
                                    : fmt::format("'{}' is not declared before; did you mean '{}'?",
                                                  name, near));
}

std::vector<PovNumber> PovValues::call(PovCursor& at, const std::string& name) {
    const Known* known = known_function(name);
    const bool takes_any = name == "min" || name == "max";
    if (!known && !takes_any) {
        std::string words = "min, max";
        for (const Known& one : known_functions) words += fmt::format(", {}", one.name);
        at.fail(for_what_, fmt::format("the function {} is not read; read are {}, and those that "
                                       "the file declares",
                                       name, words));
    }
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
    if (takes_any && arguments.size() >= 2) {
        std::vector<std::string> texts;
        texts.reserve(arguments.size());
        for (const PovNumber& argument : arguments) texts.push_back(argument.text);
        return {{fmt::format("{}({})", name, fmt::join(texts, ", ")), Strength::atom, {}}};
    }
    if (takes_any || arguments.size() != known->arguments) {
        at.fail(for_what_, fmt::format("{} takes {}, not {}", name,
                                       takes_any ? "at least 2 numbers"
                                                 : fmt::format("{} numbers", known->arguments),
                                       arguments.size()));
    }
    if (known->value && arguments[0].value) {
        const double value = known->value(*arguments[0].value);
        if (std::isfinite(value) && arguments[0].is_plain()) return {PovNumber::of(value)};
    }
    arguments.resize(5);
    const Strength strength = name == "pow" || name == "sqr" ? Strength::power : Strength::atom;
    return {{fmt::format(fmt::runtime(known->text), arguments[0].text, arguments[1].text,
                         arguments[2].text, arguments[3].text, arguments[4].text),
             strength, std::nullopt}};
}

PovNumber PovValues::call_declared(PovCursor& at, const std::string& name) {
    const Depth within(depth_, at, for_what_);
    const Function& function = functions_.at(name);
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
    const std::size_t behind = at.place();
    const Arguments* outer = arguments_;
    arguments_ = &given;
    at.go_to(function.body);
    PovValue body = sum(at);
    arguments_ = outer;
    if (body.size() != 1 || !at.now().is("}")) at.fail(name, "must be one number");
    at.go_to(behind);
    return body[0];
}

} // namespace isomotion::scene
