// Families of sums over elements, and elements drawn at random.
#pragma once

#include <array>
#include <random>

#include "formula/field.h"

namespace isomotion::elements {

inline formula::Vocabulary family_vocabulary() {
    formula::Vocabulary v;
    v.inputs = formula::coordinate_names;
    v.parameters = {"a", "h", "level", "s"};
    v.arrays = {{"p",
                 {{"cx", {}},
                  {"cy", {}},
                  {"cz", {}},
                  {"w", {}},
                  {"r", {}},
                  {"dx", {}},
                  {"gxx", {}},
                  {"gxy", {}},
                  {"gxz", {}},
                  {"gyy", {}},
                  {"gyz", {}},
                  {"gzz", {}}}}};
    return v;
}

struct Family {
    const char* name;
    const char* formula;
    bool exact;             // its lists leave nothing out
    bool lists_all = false; // all elements matter everywhere, as far as is known
};

inline constexpr Family families[] = {
    {"gaussians", "level - sum(p, exp(-a*((x-cx)^2 + (y-cy)^2 + (z-cz)^2)))", false},
    {"weighted", "level - sum(p, w*exp(-a*((x-cx)^2 + (y-cy)^2 + (z-cz)^2)/r^2))", false},
    {"written out",
     "sum(p, exp(a*(2*x*cx + 2*y*cy + 2*z*cz - cx^2 - cy^2 - cz^2 - x^2 - y^2 - z^2)))"
     " - level",
     false},
    // weights within the polynomial: terms are alike, their polynomials' least values are not
    {"offset", "level - sum(p, exp(-a*((x-cx)^2 + 0.08*(w-1) + (y-cy)^2 + (z-cz)^2)))", false},
    {"stretched", "level - sum(p, exp(-a*((x-cx)^2 + 4*(y-cy)^2 + (x-cx+z-cz)^2)))", false},
    {"paths", "level - sum(p, exp(-a*((x-cx-dx*s)^2 + (y-cy+dx*s)^2 + (z-cz)^2)))", false},
    {"logarithm", "-log(sum(p, exp(-a*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))))/a - h*h/2", false},
    {"wyvill", "level - sum(p, max(0, 1 - ((x-cx)^2 + (y-cy)^2 + (z-cz)^2)/h^2)^3)", true},
    {"selected", "level - sum(p, w*max(0, r - sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2))^2)", true},
    {"anisotropic",
     "level - sum(p, w*max(0, 1 - (gxx*(x-cx) + gxy*(y-cy) + gxz*(z-cz))^2"
     " - (gxy*(x-cx) + gyy*(y-cy) + gyz*(z-cz))^2"
     " - (gxz*(x-cx) + gyz*(y-cy) + gzz*(z-cz))^2)^3)",
     true},
    {"two sums",
     "sum(p, w*max(0, 1 - ((x-cx)^2 + (y-cy)^2 + (z-cz)^2)/h^2)^2)"
     " / (1 + sum(p, max(0, 1 - ((x-cx)^2 + (y-cy)^2 + (z-cz)^2)/r^2)^3)) - level",
     true},
    // Roots where the sum is 0.
    {"water and a post",
     "min(level - sum(p, max(0, 1 - ((x-cx)^2 + (y-cy)^2 + (z-cz)^2)/h^2)^3),"
     " sqrt((x-0.3)^2 + y^2) - 0.15)",
     true},
    {"bumps", "z - level - 0.2*sum(p, w*exp(-a*((x-cx)^2 + (y-cy)^2 + (z-cz)^2)))", false},
    // Terms without a bound.
    {"poles", "sum(p, 0.03*h*h/sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2)) - 2*level - 0.1*z", true,
     true},
    // A term of two distances, and sums of distances from different middles.
    {"pairs",
     "level + 0.1*z - sum(p, exp(-a*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))"
     "*max(0, 1 - ((x-cx-0.1)^2 + (y-cy)^2 + (z-cz)^2)/h^2))"
     " + 0.01*sum(p, exp(-a*((x-cx)^2 + (y-cy)^2 + (z-cz)^2)))",
     false},
    {"apart",
     "level - sum(p, exp(-a*((x-cx)^2 + (y-cy)^2 + (z-cz)^2)))"
     " - 0.001*sum(p, exp(-2*((x-0.02*cx)^2 + (y-0.02*cy)^2 + (z-0.02*cz)^2)))",
     false, true},
    // Kernels of a distance from a line that is along no axis: flat but for rounding.
    {"tilted rods",
     "3 - sum(p, max(0, 1 - ((x-cx)^2 + (y-cy)^2 + (z-cz)^2"
     " - (gxx*(x-cx) + gxy*(y-cy) + gxz*(z-cz))^2/(gxx^2 + gxy^2 + gxz^2))/h^2)^2)",
     true, true},
    // Kernels of a distance from a line, and from a plane.
    {"terrain", "z - 0.1*sum(p, w*exp(-a*((x-cx)^2 + (y-cy)^2)))", false},
    {"columns", "level - sum(p, max(0, 1 - ((x-cx)^2 + (z-cz)^2)/h^2)^3)", true},
    {"sheets", "y - sum(p, 0.1*w*max(0, 1 - (x-cx)^2/h^2)^2)", true},
    // Kernels of no polynomial: cubes, tents, capsules along any direction, and a square that only
    // one axis has.
    {"tents",
     "level - sum(p, w*max(0, 1 - abs(x-cx)/h)*max(0, 1 - abs(y-cy)/h)*max(0, 1 - abs(z-cz)/h))",
     true},
    {"corners", "level - sum(p, exp(-2*(abs(x-cx) + abs(y-cy) + abs(z-cz))/h))", false, true},
    {"fourth powers", "level - sum(p, exp(-((x-cx)^4 + (y-cy)^4 + (z-cz)^4)/(0.3*h)^4))", false,
     true},
    {"sheets of tents",
     "level - sum(p, max(0, 1 - (x-cx)^2/h^2)*max(0, 1 - abs(y-cy)/h)*max(0, 1 - abs(z-cz)/h))",
     true},
    {"ratio",
     "sqrt((x - sum(p, cx*max(0, 1 - ((x-cx)^2 + (y-cy)^2 + (z-cz)^2)/h^2)^3)"
     "/sum(p, max(0, 1 - ((x-cx)^2 + (y-cy)^2 + (z-cz)^2)/h^2)^3))^2 + (y - cos(z))^2) - level",
     true},
};

// Families of the least element: many bodies joined.
inline constexpr Family least_families[] = {
    {"balls", "least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2) - 0.4*r)", true},
    {"squares", "least(p, (x-cx)^2 + (y-cy)^2 + (z-cz)^2 - (0.4*r)^2)", true},
    {"moving", "least(p, sqrt((x-cx-dx*s)^2 + (y-cy+dx*s)^2 + (z-cz)^2) - 0.4*r)", true},
    {"ellipsoids",
     "least(p, sqrt((gxx*(x-cx) + gxy*(y-cy) + gxz*(z-cz))^2"
     " + (gxy*(x-cx) + gyy*(y-cy) + gyz*(z-cz))^2"
     " + (gxz*(x-cx) + gyz*(y-cy) + gzz*(z-cz))^2) - 0.3)",
     true},
    {"kernels", "0.5 - greatest(p, w*exp(-a*((x-cx)^2 + (y-cy)^2 + (z-cz)^2)))", true},
    {"shells", "abs(least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2) - 0.4*r)) - 0.05*h", true},
    {"wavy", "least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2) - 0.4*r) + 0.05*h*sin(20*x)", true},
    {"a floor", "min(least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2) - 0.4*r), z + 0.5)", true},
    {"a soft floor",
     "smoothmin(least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2) - 0.4*r), z + 0.5, 0.2*h)", true},
    {"cut", "max(least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2) - 0.4*r), 0.3*y - x)", true},
    {"holes", "max(x^2 + y^2 + z^2 - 0.8, -least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2) - 0.4*r))",
     true},
    {"cubes", "least(p, max(max(abs(x-cx), abs(y-cy)), abs(z-cz)) - 0.45*r)", true},
    {"octahedra", "least(p, abs(x-cx) + abs(y-cy) + abs(z-cz) - 0.6*r)", true},
    {"capsules",
     "least(p, sqrt((x-cx-0.2*gxx*max(0, min(1, gxx*(x-cx) + gxy*(y-cy))))^2"
     " + (y-cy-0.2*gxy*max(0, min(1, gxx*(x-cx) + gxy*(y-cy))))^2 + (z-cz)^2) - 0.5*r)",
     true},
    {"fourth powers", "min(least(p, (x-cx)^4 + (y-cy)^4 + (z-cz)^4 - (0.4*r)^4), z + 0.7)", true},
    {"tori", "least(p, sqrt((sqrt((x-cx)^2 + (y-cy)^2) - 0.4*r)^2 + (z-cz)^2) - 0.15*r)", true},
    {"rods", "least(p, sqrt((x-cx)^2 + (y-cy)^2) - 0.2*r)", true},
    // Roots that depend on a least of up to h and more.
    {"a wide blend",
     "abs(smoothmin(least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2) - 0.4*r), 0.6*z + 0.5*x + 0.2, "
     "h)) - 0.02",
     true},
};

// `spacing`: about a kernel's width, of elements in the ball of radius 1.
inline formula::Bindings<float> drawn_elements(std::mt19937& draw, int count, double spacing) {
    std::uniform_real_distribution<double> unit(-1, 1);
    formula::Bindings<float> values;
    values.parameters = {float(1 / (spacing * spacing)), float(2 * spacing), 0.3f,
                         float(unit(draw))};
    values.arrays.resize(1);
    values.arrays[0].count = count;
    values.arrays[0].fields.resize(12);
    const auto add = [&](std::size_t field, double value) {
        values.arrays[0].fields[field].push_back(float(value));
    };
    for (int e = 0; e < count; ++e) {
        std::array<double, 3> at{};
        do {
            for (double& c : at) c = unit(draw);
        } while (at[0] * at[0] + at[1] * at[1] + at[2] * at[2] > 1);
        for (std::size_t k = 0; k < 3; ++k) add(k, at[k]);
        add(3, e == 0 ? 1.5 : 1 + 0.5 * unit(draw)); // the first has the most
        add(4, spacing * (1.5 + unit(draw)));
        add(5, 0.3 * unit(draw));
        const double g = 0.7 / spacing;
        for (std::size_t k = 6; k < 12; ++k) {
            const bool diagonal = k == 6 || k == 9 || k == 11;
            add(k, g * (diagonal ? 1 + 0.5 * unit(draw) : 0.3 * unit(draw)));
        }
    }
    return values;
}

} // namespace isomotion::elements
