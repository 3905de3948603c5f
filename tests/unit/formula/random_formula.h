// Random formulas with an interpretation of their own, to hold the compiler against.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "testing.h"

namespace isomotion::formula {

// What a formula is evaluated with; `largest` follows the largest intermediate result, by which
// rounding differences may be scaled.
struct Meaning {
    Point p;
    const Bindings<double>& bindings;
    std::array<int, 2> element{};
    double largest = 1;

    double keep(double value) {
        largest = std::max(largest, std::abs(value));
        return value;
    }
};

struct RandomFormula {
    std::string text;
    std::function<double(Meaning&)> value;
};

// Sums, products, minima, powers and bounded functions: no operation that magnifies errors much.
class FormulaGenerator {
public:
    explicit FormulaGenerator(std::uint64_t seed)
        : random_(seed) {}

    RandomFormula make(int depth) {
        const int choice = depth == 0 ? random_.below(3) : 3 + random_.below(11);
        switch (choice) {
        case 0:
        case 1:
            return leaf();
        case 2: {
            const int k = random_.below(9) - 4;
            return {fmt::format("({})", k), [k](Meaning&) { return double(k); }};
        }
        case 3:
            return binary("({} + {})", depth, [](double a, double b) { return a + b; });
        case 4:
            return binary("({} - {})", depth, [](double a, double b) { return a - b; });
        case 5:
            return binary("{}*{}", depth, [](double a, double b) { return a * b; });
        case 6:
            return binary("min({}, {})", depth, [](double a, double b) { return std::min(a, b); });
        case 7:
            return binary("max({}, {})", depth, [](double a, double b) { return std::max(a, b); });
        case 8:
            return unary("sin({})", depth, [](double a) { return std::sin(a); });
        case 9:
            return unary("(-{})", depth, [](double a) { return -a; });
        case 10:
            return unary("abs({})", depth, [](double a) { return std::abs(a); });
        case 11: {
            const int n = 2 + random_.below(2);
            return unary(fmt::format("({{}})^{}", n), depth,
                         [n](double a) { return std::pow(a, n); });
        }
        case 12:
            return sum(depth);
        default:
            return least(depth);
        }
    }

private:
    RandomFormula leaf() {
        const int open = (open_[0] ? 2 : 0) + (open_[1] ? 2 : 0);
        const int choice = random_.below(5 + open);
        if (choice < 3) {
            const std::string& name = coordinate_names[std::size_t(choice)];
            return {name, [choice](Meaning& m) { return m.p[std::size_t(choice)]; }};
        }
        if (choice < 5) {
            const auto k = std::size_t(choice - 3);
            return {k == 0 ? "a" : "b", [k](Meaning& m) { return m.bindings.parameters[k]; }};
        }
        const std::size_t array = !open_[0] || choice >= 7 ? 1 : 0;
        const auto field = std::size_t(choice - 5) % 2;
        const char* names[2][2] = {{"cx", "cy"}, {"px", "py"}};
        return {names[array][field], [array, field](Meaning& m) {
                    const auto& columns = m.bindings.arrays[array];
                    return columns.fields[field][std::size_t(m.element[array])];
                }};
    }

    RandomFormula unary(const std::string& form, int depth, std::function<double(double)> f) {
        auto a = make(depth - 1);
        return {fmt::format(fmt::runtime(form), a.text),
                [f, value = a.value](Meaning& m) { return m.keep(f(value(m))); }};
    }

    RandomFormula binary(std::string_view form, int depth, double (*f)(double, double)) {
        auto a = make(depth - 1), b = make(random_.below(depth));
        return {fmt::format(fmt::runtime(form), a.text, b.text),
                [f, first = a.value, second = b.value](Meaning& m) {
                    const double left = first(m);
                    return m.keep(f(left, second(m)));
                }};
    }

    RandomFormula sum(int depth) {
        const auto array = std::size_t(random_.below(2));
        if (open_[array]) return leaf();
        open_[array] = true;
        auto body = make(depth - 1);
        open_[array] = false;
        return {fmt::format("sum({}, {})", array == 0 ? "blobs" : "links", body.text),
                [array, value = body.value](Meaning& m) {
                    double total = 0;
                    for (int i = 0; i < m.bindings.arrays[array].count; ++i) {
                        m.element[array] = i;
                        total = m.keep(total + value(m));
                    }
                    return total;
                }};
    }

    RandomFormula least(int depth) {
        const auto array = std::size_t(random_.below(2));
        if (open_[array]) return leaf();
        open_[array] = true;
        auto key = make(depth - 1);
        open_[array] = false;
        // The least of no elements would be too large for what is compared.
        return {fmt::format("min(9, least({}, {}))", array == 0 ? "blobs" : "links", key.text),
                [array, value = key.value](Meaning& m) {
                    double least = 9;
                    for (int i = 0; i < m.bindings.arrays[array].count; ++i) {
                        m.element[array] = i;
                        least = std::min(least, value(m));
                    }
                    return m.keep(least);
                }};
    }

    Random random_;
    std::array<bool, 2> open_{};
};

} // namespace isomotion::formula
