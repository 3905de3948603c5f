#include "scene/reading/mathmod_parser.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "formula/graph/limits.h"
#include "scene/reading/mathmod_functions.h"

namespace isomotion::scene::mathmod {
namespace {

using Strength = Part::Strength;

constexpr int deepest = 90; // parentheses and calls in one another; formulas have 199
// What fparser takes for equal.
constexpr const char* equal = "1e-12";

void hold(Part& part, Strength least) {
    if (part.strength >= least) return;
    part.text.insert(0, 1, '(');
    part.text += ')';
    part.strength = Strength::atom;
    ++part.depth;
}

// What the whole depends on if the part is in it.
void take_in(Part& whole, Part& part) {
    whole.inputs |= part.inputs;
    whole.may_jump |= part.may_jump;
    whole.depth = std::max(whole.depth, part.depth);
    if (whole.names.size() < part.names.size()) whole.names.swap(part.names);
    whole.names.insert(part.names.begin(), part.names.end());
    whole.parameters.insert(part.parameters.begin(), part.parameters.end());
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

class Parser {
public:
    Parser(std::string_view text, const Scope& scope, const JsonPlace& place)
        : text_(text)
        , scope_(scope)
        , place_(place) {}

    Part whole() {
        Part part = any_of();
        if (at_ < text_.size()) {
            fail(fmt::format(
                "needs an operator before '{}'",
                std::string(text_.substr(at_, std::min<std::size_t>(20, text_.size() - at_)))));
        }
        return part;
    }

private:
    [[noreturn]] void fail(const std::string& message) const { place_.fail(message); }

    char peek() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool accept(std::string_view sign) {
        peek();
        if (!text_.substr(at_).starts_with(sign)) return false;
        at_ += sign.size();
        return true;
    }
    void expect(char sign) {
        if (peek() == sign) {
            ++at_;
            return;
        }
        fail(at_ < text_.size() ? fmt::format("needs '{}' before '{}'", sign, text_[at_])
                                : fmt::format("needs '{}' at its end", sign));
    }
    Part checked(Part part) const {
        if (part.depth > 2 * deepest) fail_deep();
        return part;
    }
    [[noreturn]] void fail_deep() const {
        fail(fmt::format("has more than {} parentheses, calls and signs in one another", deepest));
    }

    // a | b, a & b
    Part any_of() { return logical("|", "or", &Parser::all_of); }
    Part all_of() { return logical("&", "and", &Parser::comparison); }
    Part logical(std::string_view sign, const char* word, Part (Parser::*operand)()) {
        Part left = (this->*operand)();
        if (!accept(sign)) return left;
        const bool is_or = sign == "|";
        const auto holds = [](const Part& part) { return std::abs(*part.value) >= 0.5; };
        std::string text = "(" + left.condition();
        do {
            accept(sign); // || and && are read as well
            Part right = (this->*operand)();
            text += fmt::format(" {} {}", word, right.condition());
            std::optional<double> value;
            if (left.value && right.value)
                value = is_or ? holds(left) || holds(right) : holds(left) && holds(right);
            take_in(left, right);
            left.value = value;
        } while (accept(sign));
        return as_condition(std::move(left), text + ")");
    }
    Part as_condition(Part part, std::string text) const {
        part.text = std::move(text);
        part.strength = Strength::atom;
        part.is_condition = part.is_never_negative = part.may_jump = true;
        ++part.depth;
        return checked(std::move(part));
    }

    Part comparison() {
        Part left = sum();
        for (;;) {
            std::string_view sign;
            for (const std::string_view one : {"<=", ">=", "!=", "==", "<", ">", "="}) {
                if (sign.empty() && accept(one)) sign = one;
            }
            if (sign.empty()) return left;
            left = compared(std::move(left), sign, sum());
        }
    }
    Part compared(Part left, std::string_view sign, Part right) const {
        const std::optional<double> value =
            left.value && right.value ? std::optional(holds(*left.value, sign, *right.value))
                                      : std::nullopt;
        std::string text;
        if (sign.back() == '=' && sign != "<=" && sign != ">=") {
            hold(right, Strength::product);
            text = fmt::format("(abs({} - {}) {} {})", left.text, right.text,
                               sign == "!=" ? ">" : "<=", equal);
        } else {
            text = fmt::format("({} {} {})", left.text, sign, right.text);
        }
        take_in(left, right);
        left.value = value;
        return as_condition(std::move(left), std::move(text));
    }
    static double holds(double a, std::string_view sign, double b) {
        if (sign == "<") return a < b;
        if (sign == ">") return a > b;
        if (sign == "<=") return a <= b;
        if (sign == ">=") return a >= b;
        return (std::abs(a - b) <= 1e-12) == (sign != "!=");
    }

    Part sum() {
        Part left = product();
        for (;;) {
            const char sign = peek();
            if (sign != '+' && sign != '-') return left;
            ++at_;
            left = joined(std::move(left), sign, product());
        }
    }
    Part product() {
        Part left = with_sign();
        for (;;) {
            const char sign = peek();
            if (sign != '*' && sign != '/' && sign != '%') return left;
            ++at_;
            left = sign == '%' ? remainder(std::move(left), with_sign())
                               : joined(std::move(left), sign, with_sign());
        }
    }
    Part joined(Part left, char sign, Part right) const {
        const bool is_sum = sign == '+' || sign == '-';
        const bool is_square = sign == '*' && left.text == right.text;
        std::optional<double> value;
        if (left.value && right.value) {
            const double a = *left.value, b = *right.value;
            value = sign == '+' ? a + b : sign == '-' ? a - b : sign == '*' ? a * b : a / b;
        }
        hold(left, is_sum ? Strength::sum : Strength::product);
        hold(right, is_sum ? Strength::product : Strength::power);
        const bool is_never_negative =
            is_square || (sign != '-' && left.is_never_negative && right.is_never_negative);
        left.text += is_sum ? fmt::format(" {} ", sign) : std::string(1, sign);
        left.text += right.text;
        take_in(left, right);
        left.strength = is_sum ? Strength::sum : Strength::product;
        left.value = value;
        left.is_condition = false;
        left.is_never_negative = is_never_negative;
        return checked(std::move(left));
    }
    Part remainder(Part left, Part right) const {
        std::optional<double> value;
        if (left.value && right.value) value = std::fmod(*left.value, *right.value);
        Part part = called("remainder", {std::move(left), std::move(right)}, value);
        part.names.insert(std::size_t(Helper::remainder));
        part.may_jump = true;
        return part;
    }

    Part with_sign() {
        const char sign = peek();
        if (sign != '-' && sign != '!' && sign != '+') return power();
        ++at_;
        if (++nested_ > deepest) fail_deep();
        Part part = with_sign();
        --nested_;
        if (sign == '+') return part;
        if (sign == '!') {
            if (part.value) part.value = std::abs(*part.value) < 0.5;
            std::string text = fmt::format("(not {})", part.condition());
            return as_condition(std::move(part), std::move(text));
        }
        if (part.value) part.value = -*part.value;
        hold(part, Strength::power);
        part.text.insert(0, 1, '-');
        part.strength = Strength::sum;
        part.is_condition = part.is_never_negative = false;
        return part;
    }

    // Powers group to the right.
    Part power() {
        Part base = element();
        if (!accept("^")) return base;
        if (++nested_ > deepest) fail_deep();
        Part exponent = with_sign();
        --nested_;
        return raised(std::move(base), std::move(exponent));
    }
    Part raised(Part base, Part exponent) const {
        const double n = exponent.value.value_or(1);
        std::optional<double> value;
        if (base.value && exponent.value) value = power_of(*base.value, n);
        if (!base.is_never_negative && exponent.value && is_root(n)) {
            Part part = called("signed_power", {std::move(base), std::move(exponent)}, value);
            part.names.insert(std::size_t(Helper::signed_power));
            return part;
        }
        hold(base, Strength::atom);
        hold(exponent, Strength::atom);
        base.is_never_negative |= exponent.value && std::fmod(n, 2) == 0;
        base.text += "^" + exponent.text;
        take_in(base, exponent);
        base.strength = Strength::power;
        base.value = value;
        base.is_condition = false;
        return checked(std::move(base));
    }
    // fparser takes such an exponent for that of an odd root, which numbers below 0 have as well.
    static bool is_root(double exponent) { return std::fmod(16 * exponent, 1) != 0; }
    static double power_of(double base, double exponent) {
        return base < 0 && is_root(exponent) ? -std::pow(-base, exponent)
                                             : std::pow(base, exponent);
    }

    Part element() {
        const char c = peek();
        if (c == '(') {
            if (++nested_ > deepest) fail_deep();
            ++at_;
            Part part = any_of();
            expect(')');
            --nested_;
            return part;
        }
        if (is_digit(c) || c == '.') return number();
        if (!is_letter(c)) {
            if (at_ >= text_.size()) fail("ends where a number or a name is needed");
            fail(fmt::format("needs a number or a name before '{}'",
                             std::string(text_.substr(at_, 20))));
        }
        const std::size_t begin = at_;
        while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
        const std::string name(text_.substr(begin, at_ - begin));
        return peek() == '(' ? call(name) : named(name);
    }
    Part number() {
        const std::size_t begin = at_;
        const auto at = [&](std::size_t k) { return k < text_.size() ? text_[k] : '\0'; };
        const auto skip_digits = [&] {
            while (is_digit(at(at_))) ++at_;
        };
        skip_digits();
        if (at(at_) == '.') ++at_;
        skip_digits();
        if (at(at_) == 'e' || at(at_) == 'E') {
            const std::size_t sign = at(at_ + 1) == '+' || at(at_ + 1) == '-';
            if (is_digit(at(at_ + 1 + sign))) {
                at_ += 1 + sign;
                skip_digits();
            }
        }
        const std::string digits(text_.substr(begin, at_ - begin));
        const double value = std::strtod(digits.c_str(), nullptr);
        if (!std::isfinite(value)) fail(digits + " is too large a number");
        if (digits == ".") fail("needs a number in place of '.'");
        return number_part(value);
    }

    Part named(const std::string& name) const {
        if (name == "pi") {
            Part pi;
            pi.text = name;
            pi.value = std::numbers::pi;
            pi.is_never_negative = true;
            return pi;
        }
        if (const auto found = scope_.inputs.find(name); found != scope_.inputs.end())
            return found->second;
        if (scope_.values) {
            const auto& meanings = scope_.values->meanings();
            const auto found = meanings.find(name);
            if (found != meanings.end() && found->second.kind == Values::Meaning::Kind::part)
                return as_named(found->second.part, name);
            if (found != meanings.end())
                fail(fmt::format("'{0}' is a function; write {0}(x, y, z, t)", name));
        }
        fail(fmt::format("unknown name '{}'{}", name, hint(name, false)));
    }
    Part as_named(const Part& part, const std::string& name) const {
        if (scope_.names_constants) return part;
        if (part.value) return number_part(*part.value);
        if (!scope_.values->parameters_of(part).empty()) return part;
        fail(fmt::format("'{}' depends on the place; limits are the same everywhere", name));
    }
    std::string hint(const std::string& name, bool is_call) const {
        std::vector<std::string> names;
        if (is_call) {
            names = function_names();
        } else {
            names.emplace_back("pi");
            for (const auto& [input, part] : scope_.inputs) names.push_back(input);
        }
        if (scope_.values) {
            for (const auto& [known, meaning] : scope_.values->meanings()) {
                if ((meaning.kind == Values::Meaning::Kind::function) == is_call)
                    names.push_back(known);
            }
        }
        const std::string near = base::nearest_name(name, names);
        return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
    }

    std::vector<Part> arguments() {
        if (++nested_ > deepest) fail_deep();
        std::vector<Part> list;
        expect('(');
        do {
            list.push_back(any_of());
        } while (accept(","));
        expect(')');
        --nested_;
        return list;
    }
    void expect_count(const std::string& name, std::size_t given, std::size_t wanted) const {
        if (given == wanted) return;
        fail(fmt::format("'{}' takes {} argument{}, not {}", name, wanted, wanted == 1 ? "" : "s",
                         given));
    }

    Part call(const std::string& name) {
        if (scope_.values && scope_.has_functions) {
            const auto& meanings = scope_.values->meanings();
            const auto found = meanings.find(name);
            if (found != meanings.end() && found->second.kind == Values::Meaning::Kind::function)
                return call_defined(name, found->second.function);
        }
        if (is_mathmods_own(name)) {
            fail(fmt::format("'{}' is a function of MathMod itself, which this program does not "
                             "have",
                             name));
        }
        if (name == "if") return choice();
        if (name == "pow") {
            std::vector<Part> list = arguments();
            expect_count(name, list.size(), 2);
            return raised(std::move(list[0]), std::move(list[1]));
        }
        const Function* known = find_function(name);
        if (!known) fail(fmt::format("unknown function '{}'{}", name, hint(name, true)));
        std::vector<Part> list = arguments();
        expect_count(name, list.size(), known->arguments());
        std::vector<double> numbers;
        for (const Part& part : list)
            if (part.value) numbers.push_back(*part.value);
        std::optional<double> value;
        if (numbers.size() == list.size()) {
            value =
                known->of_two ? known->of_two(numbers[0], numbers[1]) : known->of_one(numbers[0]);
        }
        const auto is_never_negative = [](const Part& part) { return part.is_never_negative; };
        const bool is_extreme = name == "max" || name == "min";
        const bool never_negative = !is_extreme     ? known->is_never_negative
                                    : name == "max" ? std::ranges::any_of(list, is_never_negative)
                                                    : std::ranges::all_of(list, is_never_negative);
        Part part = called(known->ours, std::move(list), value);
        part.is_never_negative = never_negative;
        part.may_jump |= known->may_jump;
        if (known->helper) part.names.insert(std::size_t(*known->helper));
        return part;
    }
    Part called(std::string_view name, std::vector<Part> list, std::optional<double> value) const {
        Part part;
        part.text = fmt::format("{}(", name);
        for (std::size_t k = 0; k < list.size(); ++k) {
            if (k > 0) part.text += ", ";
            part.text += list[k].text;
            take_in(part, list[k]);
        }
        part.text += ')';
        part.value = value;
        ++part.depth;
        return checked(std::move(part));
    }
    Part choice() {
        std::vector<Part> list = arguments();
        expect_count("if", list.size(), 3);
        std::optional<double> value;
        if (const auto& condition = list[0].value)
            value = list[std::abs(*condition) >= 0.5 ? 1 : 2].value;
        const bool is_never_negative = list[1].is_never_negative && list[2].is_never_negative;
        list[0].text = list[0].condition();
        Part part = called("if", std::move(list), value);
        part.is_never_negative = is_never_negative;
        part.may_jump = true;
        return part;
    }
    // Names in the call only what the function depends on.
    Part call_defined(const std::string& name, std::size_t function) {
        std::vector<Part> list = arguments();
        expect_count(name, list.size(), 4);
        const Values::Definition& defined = scope_.values->definition(function);
        std::vector<Part> needed;
        constexpr std::array order{Part::x, Part::y, Part::z, Part::t};
        for (std::size_t k = 0; k < order.size(); ++k) {
            if (defined.part.inputs.test(order[k])) needed.push_back(std::move(list[k]));
        }
        Part part = called(defined.name, std::move(needed), defined.part.value);
        if (defined.arguments.empty()) {
            part.text = defined.name;
            part.depth = 0;
        }
        part.is_never_negative = defined.part.is_never_negative;
        part.may_jump |= defined.part.may_jump;
        part.names.insert(function);
        return part;
    }

    std::string_view text_;
    const Scope& scope_;
    const JsonPlace& place_;
    std::size_t at_ = 0;
    int nested_ = 0;
};

} // namespace

Part parsed(std::string_view text, const Scope& scope, const JsonPlace& at) {
    if (text.size() > formula::limits::formula_bytes) {
        at.fail(fmt::format("has {} bytes; a formula has at most {}", text.size(),
                            formula::limits::formula_bytes));
    }
    return Parser(text, scope, at).whole();
}

} // namespace isomotion::scene::mathmod
