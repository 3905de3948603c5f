#include "families.h"

#include <array>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace isomotion::bench {

// Has distributions of its own: those of one standard library differ from those of another.
class Draw {
public:
    explicit Draw(std::uint64_t seed)
        : random_(seed) {}

    int below(int n) { return int(random_() % std::uint64_t(n)); }
    double in(double a, double b) { return a + (b - a) * double(random_() >> 11) * 0x1p-53; }
    std::string number(double a, double b) { return fmt::format("{:.4g}", in(a, b)); }
    template<std::size_t N> std::string any_of(const std::array<const char*, N>& of) {
        return of[std::size_t(below(int(N)))];
    }

private:
    std::mt19937_64 random_;
};

namespace {

std::string axis(Draw& d) { return d.any_of(std::array{"u", "v", "w"}); }

// (a*u + b*v + c*w + e), with coefficients of a size.
std::string linear(Draw& d, double size) {
    return fmt::format("({}*u + {}*v + {}*w + {})", d.number(-size, size), d.number(-size, size),
                       d.number(-size, size), d.number(-1, 1));
}

std::string ball(Draw& d, double most) {
    return fmt::format("((u - {})^2 + (v - {})^2 + (w - {})^2 - {}^2)", d.number(-1, 1),
                       d.number(-1, 1), d.number(-1, 1), d.number(0.2, most));
}

std::string ellipsoid(Draw& d) {
    return fmt::format("({}*u^2 + {}*v^2 + {}*w^2 - 1)", d.number(0.5, 3), d.number(0.5, 3),
                       d.number(0.5, 3));
}

std::string torus(Draw& d) {
    const std::string r = d.number(0.5, 1.2), s = d.number(0.1, 0.4);
    return fmt::format("((u^2 + v^2 + w^2 + {0}^2 - {1}^2)^2 - 4*{0}^2*(u^2 + v^2))", r, s);
}

std::string quadric(Draw& d) {
    return fmt::format("({}*u*u + {}*v*v + {}*w*w + {}*u*v + {}*v*w + {})", d.number(-2, 2),
                       d.number(-2, 2), d.number(-2, 2), d.number(-1, 1), d.number(-1, 1),
                       d.number(-1, 1));
}

std::string dense_polynomial(Draw& d) {
    const int degree = 3 + d.below(6);
    std::string text;
    for (int term = 0; term < 4 + degree; ++term) {
        std::array<int, 3> powers{};
        for (int k = 0, n = 1 + d.below(degree); k < n; ++k) ++powers[std::size_t(d.below(3))];
        text += fmt::format("{}{}*u^{}*v^{}*w^{}", term ? " + " : "", d.number(-2, 2), powers[0],
                            powers[1], powers[2]);
    }
    return fmt::format("{} + {}", text, d.number(-0.5, 0.5));
}

std::string polynomial(Draw& d) {
    switch (d.below(8)) {
    case 0: // nodes
        return fmt::format("{}*{} - {}*{}", quadric(d), quadric(d), linear(d, 1), linear(d, 1));
    case 1: // cuspidal edges
        return fmt::format("{}^2 - {}*{}^3", quadric(d), d.number(0.3, 2), linear(d, 1));
    case 2: // double lines
        return fmt::format("{}^2 - {}*{}^2", linear(d, 1), quadric(d), linear(d, 1));
    case 3: // two sheets that touch
        return fmt::format("{}*(w - {}*u^2 - {}*v^2)", axis(d), d.number(-1, 1), d.number(-1, 1));
    case 4: // nearly a double surface
        return fmt::format("{}^2 - {}", ellipsoid(d), d.number(0, 0.02));
    case 5: // double points
        return fmt::format("u^2 + v^2 - w^2*({} - w)*{}", d.number(0.2, 1.5), d.number(0.2, 2));
    default:
        return dense_polynomial(d);
    }
}

std::string smooth(Draw& d) {
    const auto wave = [&] {
        return fmt::format("{}({})", d.any_of(std::array{"sin", "cos"}), linear(d, 4));
    };
    switch (d.below(5)) {
    case 0:
        return fmt::format("{} + {} + {} - {}", wave(), wave(), wave(), d.number(-1, 1));
    case 1:
        return fmt::format("{}*{} + {}", wave(), wave(), linear(d, 1));
    case 2:
        return fmt::format("exp(-{}) + exp(-{}) - {}", ellipsoid(d), ball(d, 1),
                           d.number(0.5, 1.5));
    case 3:
        return fmt::format("{} - {}*tanh({}) + {}*{}", ball(d, 1), d.number(0.1, 1), linear(d, 4),
                           d.number(0, 0.2), wave());
    default:
        return fmt::format("w - {}*sin({}*u + {}*cos({}*v))", d.number(0.1, 0.6), d.number(1, 6),
                           d.number(0, 2), d.number(1, 5));
    }
}

// Many waves within the bounds, round or sharp, with little between them.
std::string waves(Draw& d) {
    const std::string k = d.number(5, 40),
                      sines = fmt::format("sin({0}*u)*sin({0}*v)*sin({0}*w)", k);
    switch (d.below(8)) {
    case 0:
        return fmt::format("{} - {}", sines, d.number(0.2, 0.9));
    case 1:
        return fmt::format("cos({0}*u) + cos({0}*v) + cos({0}*w) - {1}", k, d.number(0, 2.5));
    case 2:
        return fmt::format("{} - {}*{}", ball(d, 1.2), d.number(0.02, 0.3), sines);
    case 3:
        return fmt::format("w - {1}*sin({0}*u)*sin({2}*v)", k, d.number(0.02, 0.2),
                           d.number(5, 40));
    case 4:
        return fmt::format("sin({}*u*v*w) - {}", d.number(3, 20), d.number(0, 0.8));
    case 5:
        return fmt::format("exp(sin({0}*u) + sin({0}*v) + sin({0}*w)) - {1}", k, d.number(1, 9));
    case 6:
        return fmt::format("tanh({1}*(sin({0}*u)*cos({0}*v) + sin({0}*v)*cos({0}*w) + "
                           "sin({0}*w)*cos({0}*u))) - {2}",
                           k, d.number(1, 5), d.number(0, 0.8));
    default: {
        const std::string wave = d.number(2, 8);
        return fmt::format("1/(1 + {1}*sin({0}*u)^2) + 1/(1 + {1}*sin({0}*v)^2) + "
                           "1/(1 + {1}*sin({0}*w)^2) - {2}",
                           wave, d.number(5, 60), d.number(1.1, 2.5));
    }
    }
}

std::string body(Draw& d) {
    switch (d.below(6)) {
    case 0:
        return ball(d, 0.9);
    case 1:
        return linear(d, 1);
    case 2:
        return fmt::format("((u - {})^2 + (v - {})^2 - {}^2)", d.number(-1, 1), d.number(-1, 1),
                           d.number(0.1, 0.6));
    case 3:
        return torus(d);
    case 4: {
        const std::string a = d.number(0.3, 1);
        return fmt::format("max(max(abs(u) - {}, abs(v) - {}), abs(w) - {})", a, d.number(0.3, 1),
                           a);
    }
    default:
        return ellipsoid(d);
    }
}

std::string tree(Draw& d, int depth) {
    if (depth == 0) return body(d);
    const std::string a = tree(d, depth - 1), b = tree(d, d.below(depth));
    switch (d.below(3)) {
    case 0:
        return fmt::format("min({}, {})", a, b);
    case 1:
        return fmt::format("max({}, {})", a, b);
    default:
        return fmt::format("max({}, -{})", a, b);
    }
}

std::string csg(Draw& d) { return tree(d, 1 + d.below(5)); }

std::string shell(Draw& d) {
    const std::string thick = d.number(0.01, 0.2);
    switch (d.below(3)) {
    case 0:
        return fmt::format("abs({}) - {}", body(d), thick);
    case 1:
        return fmt::format("max(abs({}) - {}, {})", ball(d, 1.2), thick, linear(d, 1));
    default:
        return fmt::format("abs({}) - {}", smooth(d), thick);
    }
}

std::string fractional(Draw& d) {
    const auto power = [&](const char* of) {
        return fmt::format("abs({})^{}", of, d.number(0.2, 3));
    };
    switch (d.below(3)) {
    case 0:
        return fmt::format("{} + {} + {} - 1", power("u"), power("v"), power("w"));
    case 1:
        return fmt::format("sqrt(abs({})) + {} - {}", linear(d, 1), power("v"), d.number(0.5, 1.5));
    default:
        return fmt::format("(sqrt(u^2 + v^2) - {})^2 + {} - {}", d.number(0.4, 1), power("w"),
                           d.number(0.05, 0.2));
    }
}

// Functions beyond whose domain formulas go: sqrt is 0 there, asin and acos stay as at its end.
std::string roots(Draw& d) {
    const auto beyond = [&] {
        const std::string root = d.any_of(std::array{"sqrt", "asin", "acos"});
        switch (d.below(4)) {
        case 0:
            return fmt::format("{}({})", root, linear(d, 1.5));
        case 1:
            return fmt::format("{}({})", root, ball(d, 1));
        case 2:
            return fmt::format("{}({}*sin({}))", root, d.number(0.5, 2), linear(d, 3));
        default:
            return fmt::format("{}({} - {}^2)", root, d.number(0.1, 1), axis(d));
        }
    };
    switch (d.below(4)) {
    case 0:
        return fmt::format("{} - {}*{}", axis(d), d.number(0.2, 0.8), beyond());
    case 1:
        return fmt::format("{} + {} - {}", beyond(), beyond(), d.number(0.2, 2));
    case 2:
        return fmt::format("{} + {}*{}", ball(d, 1.2), d.number(-0.6, 0.6), beyond());
    default:
        return fmt::format("exp({}) - {} - {}*{}", beyond(), d.number(0.5, 2), d.number(0.3, 1),
                           axis(d));
    }
}

std::string poles(Draw& d) {
    switch (d.below(5)) {
    case 0:
        return fmt::format("1/(u - {}) + 1/(v - {}) + {}*w", d.number(-1, 1), d.number(-1, 1),
                           d.number(0.5, 3));
    case 1:
        return fmt::format("{}/{} + {}", quadric(d), linear(d, 1), linear(d, 1));
    case 2:
        return fmt::format("tan({}) + {}", linear(d, 2), linear(d, 2));
    case 3:
        return fmt::format("1/{} + 1/{} - {}", ball(d, 0.8), ball(d, 0.8), d.number(-3, 3));
    default:
        return fmt::format("log({}) + {}", d.any_of(std::array{"u^2 + v^2", "abs(u)", "u + 1.5"}),
                           linear(d, 1));
    }
}

std::string elements(Draw& d) {
    const std::string apart = "((u - cx)^2 + (v - cy)^2 + (w - cz)^2)";
    if (d.below(2) == 0)
        return fmt::format("sum(blobs, exp(-a*{})) - {}", apart, d.number(0.2, 0.9));
    return fmt::format("sum(blobs, max(0, 1 - {}*a/8)^3) - {}", apart, d.number(0.1, 0.6));
}

std::string jumps(Draw& d) {
    switch (d.below(5)) {
    case 0:
        return fmt::format("w - floor({}*u)/{}", d.number(1, 4), d.number(4, 8));
    case 1:
        return fmt::format("{} + {}*sign({})", ball(d, 1), d.number(0.1, 0.4), linear(d, 1));
    case 2:
        return fmt::format("{} - {}*floor({})", ellipsoid(d), d.number(0.05, 0.3), linear(d, 3));
    case 3:
        return fmt::format("sign({})*{}", linear(d, 1), ball(d, 1));
    default:
        return fmt::format("u^2 + v^2 + (w - floor(w*{0})/{0})^2*{1} - {2}", d.number(1, 3),
                           d.number(1, 4), d.number(0.3, 1));
    }
}

constexpr Family all[]{
    {"polynomial", polynomial},
    {"smooth", smooth},
    {"csg", csg},
    {"shell", shell},
    {"power", fractional},
    {"pole", poles},
    {"sum", elements, true},
    {"jump", jumps},
    {"root", roots},
    {"wave", waves},
};

// The rows of a rotation by a random unit quaternion.
std::array<std::array<double, 3>, 3> rotation(Draw& d) {
    std::array<double, 4> q{};
    double size = 0;
    do {
        size = 0;
        for (double& part : q) {
            part = d.in(-1, 1);
            size += part * part;
        }
    } while (size > 1 || size < 0.01);
    for (double& part : q) part /= std::sqrt(size);
    const auto [w, x, y, z] = q;
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
             {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
             {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
}

} // namespace

std::span<const Family> families() { return all; }

std::string random_scene(const Family& family, std::uint64_t seed, int size) {
    Draw d(seed * 0x9E3779B97F4A7C15u + std::uint64_t(&family - all));
    const auto turn = rotation(d);
    std::string placed;
    for (int k = 0; k < 3; ++k) {
        const auto& row = turn[std::size_t(k)];
        placed += fmt::format("{} = {:.6g}*x + {:.6g}*y + {:.6g}*z - {}; ", "uvw"[k], row[0],
                              row[1], row[2], d.number(-0.3, 0.3));
    }
    std::string text = fmt::format("[surface]\nformula = \"{}{}\"\n", placed, family.formula(d));
    text += d.below(2) == 0 ? "bounds = { sphere = 1.8 }\n"
                            : "bounds = { box = [[-1.5, -1.4, -1.6], [1.6, 1.5, 1.4]] }\n";
    if (family.has_elements) {
        const int count = 5 + d.below(46);
        const auto list = [&](double least, double most) {
            std::string numbers;
            for (int k = 0; k < count; ++k)
                numbers += fmt::format("{}{}", k ? ", " : "", d.number(least, most));
            return numbers;
        };
        text += fmt::format("[arrays.blobs]\ncount = {}\ncx = [{}]\ncy = [{}]\ncz = [{}]\na = "
                            "[{}]\n",
                            count, list(-1, 1), list(-1, 1), list(-1, 1), list(4, 40));
    }
    text += fmt::format("[camera]\nazimuth = {}\nelevation = {}\n[output]\nsize = [{}, {}]\n",
                        d.number(0, 360), d.number(-80, 80), size, size);
    return text;
}

} // namespace isomotion::bench
