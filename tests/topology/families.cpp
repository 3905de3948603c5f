#include "topology/families.h"

#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "topology/chance.h"

namespace isomotion::topology {
namespace {

std::string list(Chance& chance, int count, double low, double high) {
    std::string text = "[";
    for (int k = 0; k < count; ++k)
        text += fmt::format("{}{:.4f}", k > 0 ? ", " : "", chance.number(low, high));
    return text + "]";
}

// Keys from one value to another within 2 s, in two to four parts of random lengths.
std::string keys(Chance& chance, double from, double to) {
    const int parts = 2 + chance.below(3);
    std::string text;
    double time = 0;
    for (int k = 0; k <= parts; ++k) {
        const double way = k == 0 ? 0 : k == parts ? 1 : chance.number(-0.2, 1.2);
        text +=
            fmt::format("{}[{:.3f}, {:.4f}]", k > 0 ? ", " : "", time, from + way * (to - from));
        time = k + 1 == parts ? 2 : time + chance.number(0.2, 0.6);
    }
    return fmt::format("{{ keys = [{}], ease = \"{}\" }}", text,
                       chance.is_one_in(2) ? "linear" : "cubic");
}

enum class Way { straight, written_out, circle, keys, rays };
constexpr std::array ways{"straight paths", "straight paths in the formula", "circles", "keys",
                          "rays"};
enum class Term { gaussian, bell };

struct Parts {
    std::string parameters, arrays, formula;
};

// One array and its sum. Elements are as far apart as a cube of so many of them has them.
void add_array(Chance& chance, Parts& parts, int number, int count, int of_all, Way way,
               Term term) {
    const std::string name(1, char('a' + number));
    const double sharpness = 62 * std::pow(of_all / 75.0, 2.0 / 3);
    const double reach = 1 / std::sqrt(sharpness);
    std::string fields;
    std::array<std::string, 3> places;
    for (int k = 0; k < 3; ++k) {
        const char axis = "xyz"[k];
        fields += fmt::format("u{} = {}\n", axis, list(chance, count, -0.85, 0.85));
        const std::string along = list(chance, count, -2.5 * reach, 2.5 * reach);
        if (way != Way::rays) fields += fmt::format("v{} = {}\n", axis, along);
        places[std::size_t(k)] = fmt::format("c{}", axis);
        switch (way) {
        case Way::straight:
            fields += fmt::format("c{0} = \"u{0} + s*v{0}\"\n", axis);
            break;
        case Way::written_out:
            places[std::size_t(k)] = fmt::format("u{0} - s*v{0}", axis);
            break;
        case Way::circle:
            fields += fmt::format("c{0} = \"u{0} + v{0}*{1}(1.6*t + 6.3*random(i, {2}))\"\n", axis,
                                  k == 1 ? "sin" : "cos", number);
            break;
        case Way::keys:
            fields += fmt::format("c{0} = \"u{0} + v{0}*k{1}\"\n", axis, (number + k) % 3);
            break;
        case Way::rays:
            fields += fmt::format("c{0} = \"(1.25 - 0.45*s)*u{0}\"\n", axis);
            break;
        }
    }
    const std::string squares =
        fmt::format("((x - {})^2 + (y - {})^2 + (z - {})^2)", places[0], places[1], places[2]);
    std::string size = fmt::format("{:.2f}", sharpness);
    if (chance.is_one_in(3)) {
        // Sizes that move, each element's by itself.
        fields += fmt::format("q = {}\n", list(chance, count, -0.35, 0.35));
        fields += fmt::format("h = \"{}*(1 + q*sin(2*t + i))\"\n", size);
        size = "h";
    }
    std::string factor;
    if (chance.is_one_in(3)) {
        // A few of them are below 0: they dig holes.
        fields += fmt::format("w = {}\n", list(chance, count, number == 0 ? 0.6 : -0.5, 1.3));
        factor = "w*";
    }
    // A bell has its curvature at the middle as the Gaussian has, and a tail that has no end.
    const std::string body = term == Term::gaussian
                                 ? fmt::format("{}exp(-{}*{})", factor, size, squares)
                                 : fmt::format("{}1/(1 + 0.5*{}*{})^2", factor, size, squares);
    parts.arrays += fmt::format("[arrays.{}]\ncount = {}\n{}", name, count, fields);
    parts.formula += fmt::format(" - sum({}, {})", name, body);
}

} // namespace

FamilyDraw draw_family(unsigned seed, int fewest, int most) {
    Chance chance(seed);
    const double share = chance.number(0, 1);
    const int count = fewest + int(std::lround((most - fewest) * share * share));
    const Way way = Way(chance.below(int(ways.size())));
    const Term term = chance.is_one_in(3) ? Term::bell : Term::gaussian;
    const int arrays = chance.is_one_in(2) ? 1 : 2 + chance.below(2);
    Parts parts;
    for (int number = 0, left = count; number < arrays; ++number) {
        const int own = number + 1 == arrays ? left : (count + arrays - 1) / arrays;
        add_array(chance, parts, number, own, count, way, term);
        left -= own;
    }
    // Tails of bells add up: about this much wherever many are near.
    const double level = term == Term::gaussian ? 0.35 : 1.1;
    const bool is_level_moving = chance.is_one_in(3);
    const bool has_way = way == Way::straight || way == Way::written_out || way == Way::rays;
    const bool is_by_keys = has_way && chance.is_one_in(3);
    if (has_way)
        parts.parameters += fmt::format("s = {}\n", is_by_keys ? keys(chance, 0, 1) : "\"t/2\"");
    for (int k = 0; k < 3 && way == Way::keys; ++k)
        parts.parameters += fmt::format("k{} = {}\n", k, keys(chance, -0.5, 0.5));
    parts.parameters += is_level_moving ? fmt::format("T = \"{} + {:.3f}*sin(1.7*t + {:.2f})\"\n",
                                                      level, 0.2 * level, chance.number(0, 6))
                                        : fmt::format("T = {}\n", level);
    const bool is_ball = chance.is_one_in(4), is_cut = chance.is_one_in(3);
    const std::string bounds =
        is_ball ? fmt::format("{{ sphere = {:.3f} }}", is_cut ? chance.number(0.8, 1) : 2.2)
                : fmt::format("{{ box = [[-{0:.3f}, -{1:.3f}, -{0:.3f}], [{0:.3f}, {1:.3f}, "
                              "{2:.3f}]] }}",
                              is_cut ? chance.number(0.7, 0.8) : 1.71, is_cut ? 0.76 : 1.73,
                              is_cut ? 0.81 : 1.69);
    FamilyDraw drawn;
    drawn.name = fmt::format(
        "seed {}: {} {} in {} array{}, {}, {}{}{}{}", seed, count,
        term == Term::gaussian ? "Gaussians" : "bells", arrays, arrays > 1 ? "s" : "",
        ways[std::size_t(way)], is_ball ? "in a ball" : "in a box", is_cut ? " that cuts them" : "",
        is_level_moving ? ", a level that moves" : "", is_by_keys ? ", by keys" : "");
    drawn.text = fmt::format("title = \"{}\"\n[time]\nfps = 30\nframes = 61\n[surface]\nformula = "
                             "\"T{}\"\nbounds = {}\n[parameters]\n{}{}",
                             drawn.name, parts.formula, bounds, parts.parameters, parts.arrays);
    return drawn;
}

} // namespace isomotion::topology
