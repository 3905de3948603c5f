// Colours by place, pixel by pixel, against closed forms in double on the CPU.
#include "render/material_colors.h"

#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "image/frame.h"
#include "shader/assemble.h"
#include "unit/image/places.h"

namespace isomotion::render {
namespace {

class ColoredPictures : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(ColoredPictures);

constexpr double step_of_8_bits = 1.0 / 255;

template<class Color>
void expect_colors(const Picture& picture, std::size_t fewest, Color&& color,
                   double within = 2 * step_of_8_bits) {
    const std::vector<Pixel> hits = hits_of(picture);
    ASSERT_GT(hits.size(), fewest);
    double worst = 0;
    for (const Pixel& hit : hits) {
        const glm::dvec3 d = glm::abs(hit.color - color(hit));
        const double off = std::max({d.r, d.g, d.b});
        if (!(off <= worst)) worst = off;
    }
    EXPECT_LE(worst, within);
}

constexpr const char* distance = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)";

struct Element {
    glm::dvec3 centre, color;
    double weight = 1;
};

// `formula` is of sums over p, whose elements these are.
std::string scene_text(const std::string& formula, const std::vector<Element>& elements,
                       const std::string& more, const std::string& names = "rgb") {
    std::string columns[7];
    for (const Element& e : elements) {
        const double values[] = {e.centre.x, e.centre.y, e.centre.z, e.color.r,
                                 e.color.g,  e.color.b,  e.weight};
        for (int k = 0; k < 7; ++k) columns[k] += fmt::format("{}, ", values[k]);
    }
    std::string text = fmt::format("[surface]\nformula = \"{}\"\nbounds = {{ sphere = 3 }}\n"
                                   "[camera]\nposition = [1, 8, 2]\n[output]\nsize = [96, 64]\n"
                                   "[arrays.p]\ncount = {}\n",
                                   formula, elements.size());
    const std::string fields[] = {
        "cx", "cy", "cz", names.substr(0, 1), names.substr(1, 1), names.substr(2, 1), "w"};
    for (int k = 0; k < 7; ++k) {
        if (k == 6 && formula.find("w*") == formula.npos) continue;
        text += fmt::format("{} = [{}]\n", fields[k], columns[k]);
    }
    return text + more + dark;
}

template<class Kernel>
glm::dvec3 mean(const std::vector<Element>& elements, const glm::dvec3& p, Kernel&& kernel) {
    glm::dvec3 sum(0);
    double all = 0;
    for (const Element& e : elements) {
        const glm::dvec3 d = p - e.centre;
        const double weight = e.weight * kernel(glm::dot(d, d));
        sum += weight * e.color;
        all += weight;
    }
    return sum / all;
}

double gauss(double square) { return std::exp(2 - 2 * square); }
double hat(double square) { return std::pow(std::max(0.0, 1 - square / 1.44), 3); }

const glm::dvec3 red(1, 0, 0), blue(0, 0, 1);

// Whether it is asked for or the arrays' own; beside all elements, and of many by place.
TEST_P(ColoredPictures, OfTheLeastElementAreItsOwn) {
    std::mt19937 draw(11);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const int count : {3, 40, 700}) {
        std::vector<Element> elements;
        for (int k = 0; k < count; ++k) {
            const glm::dvec3 at(unit(draw), unit(draw), unit(draw));
            elements.push_back({4.0 * at - 2.0, {unit(draw), unit(draw), unit(draw)}});
        }
        const double radius = 0.9 / std::cbrt(count);
        const std::string key = fmt::format("sqrt({}) - {}", distance, radius);
        const std::string asked =
            fmt::format("[material]\ncolor = [\"least(p, {0}, r)\", \"least(p, {0}, g)\", "
                        "\"least(p, {0}, b)\"]\n",
                        key);
        for (const std::string& more : {std::string(), asked}) {
            const auto scene =
                scene_of(scene_text(fmt::format("least(p, {})", key), elements, more));
            const Picture picture = render::draw(*context, scene);
            int close = 0; // to another one
            expect_colors(picture, 300, [&](const Pixel& pixel) {
                double least = 1e30, next = 1e30;
                glm::dvec3 color(0);
                for (const Element& e : elements) {
                    const double away = glm::distance(pixel.position, e.centre);
                    if (away < least) {
                        next = least;
                        least = away;
                        color = e.color;
                    } else {
                        next = std::min(next, away);
                    }
                }
                if (next - least > 1e-4) return color;
                ++close;
                return pixel.color;
            });
            EXPECT_LT(close, 20);
        }
    }
}

// Where a root is not the least element's, the element that is least there may be far away.
TEST_P(ColoredPictures, OfTheLeastElementAlsoFarFromIt) {
    std::vector<Element> elements;
    for (int k = 0; k < 700; ++k) {
        const bool is_left = k % 2 == 0;
        elements.push_back({{is_left ? -1.6 : 1.6, 0.002 * k, 1}, is_left ? red : blue});
    }
    const auto scene = scene_of(
        scene_text(fmt::format("min(least(p, sqrt({}) - 0.1), z + 1)", distance), elements, ""));
    const Picture picture = render::draw(*context, scene);
    expect_colors(picture, 300, [&](const Pixel& pixel) {
        return std::abs(pixel.position.x) < 1e-3 ? pixel.color : pixel.position.x < 0 ? red : blue;
    });
}

TEST_P(ColoredPictures, TwoBlobsThatMergeShowTheMeanOfTheirColours) {
    for (const double apart : {1.6, 0.9, 0.4}) {
        const std::vector<Element> two{{{-apart, 0, 0}, red}, {{apart, 0.1, 0}, blue}};
        const auto scene =
            scene_of(scene_text(fmt::format("1 - sum(p, exp(2 - 2*{}))", distance), two, ""));
        const Picture picture = draw(*context, scene);
        expect_colors(picture, 300, [&](const Pixel& p) { return mean(two, p.position, gauss); });
        if (apart < 0.9) continue;
        // Far from the other, each is its own colour.
        std::size_t left = 0, right = 0;
        for (const Pixel& p : hits_of(picture)) {
            if (p.position.x < -apart - 0.4)
                left += glm::distance(p.color, red) < 2 * step_of_8_bits;
            if (p.position.x > apart + 0.4)
                right += glm::distance(p.color, blue) < 2 * step_of_8_bits;
        }
        EXPECT_GT(left, 20u) << apart;
        EXPECT_GT(right, 20u) << apart;
    }
}

TEST_P(ColoredPictures, OneElementGivesItsColour) {
    const std::vector<Element> one{{{0.3, 0, 0}, {0.25, 0.5, 0.125}}};
    const auto scene =
        scene_of(scene_text(fmt::format("1 - sum(p, exp(2 - 2*{}))", distance), one, ""));
    expect_colors(
        draw(*context, scene), 300, [&](const Pixel&) { return one[0].color; }, 1e-6);
}

TEST_P(ColoredPictures, TheOrderOfElementsDoesNotMatter) {
    std::vector<Element> several;
    for (int k = 0; k < 7; ++k) {
        several.push_back({{1.6 * std::cos(2.0 * k), 0.7 * std::sin(3.0 * k), std::sin(1.0 * k)},
                           {0.1 * k, 0.5, 1 - 0.1 * k},
                           0.7 + 0.1 * k});
    }
    const auto picture = [&] {
        return draw(*context, scene_of(scene_text(
                                  fmt::format("0.3 - sum(p, w*max(0, 1 - {}/1.44)^3)", distance),
                                  several, "")));
    };
    const Picture before = picture();
    expect_colors(before, 300, [&](const Pixel& p) { return mean(several, p.position, hat); });
    std::reverse(several.begin(), several.end());
    std::swap(several[1], several[4]);
    const Picture after = picture();
    for (const char* name : {"R", "G", "B"}) {
        const auto &a = before.frame.find(name)->samples, &b = after.frame.find(name)->samples;
        for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], step_of_8_bits) << k;
    }
}

// Beyond all kernels, on another part of the surface, it is the material's.
TEST_P(ColoredPictures, WhereNoElementReachesIsTheMaterials) {
    const std::vector<Element> one{{{1.5, 0, 0}, blue}};
    const std::string formula = fmt::format(
        "min(0.3 - sum(p, max(0, 1 - {}/0.36)^3), (x + 1)^2 + y^2 + z^2 - 0.5)", distance);
    expect_colors(
        draw(*context, scene_of(scene_text(formula, one, ""))), 200,
        [](const Pixel& p) { return p.position.x > 0.5 ? blue : glm::dvec3(0.72, 0.32, 0.08); },
        1e-6);
}

// The particles of fluids: a mean position, a mean radius. The weight is that of the means.
TEST_P(ColoredPictures, ARatioOfSumsShowsTheMeanByItsWeights) {
    const std::vector<Element> three{
        {{-1, 0, 0}, red}, {{0, 0.3, 0.2}, {0, 1, 0}}, {{1, 0, -0.3}, blue}};
    const std::string k = fmt::format("exp(2 - 2*{})", distance);
    const auto part = [&](char axis) {
        return fmt::format("({0} - sum(p, c{0}*{1})/sum(p, {1}))^2", axis, k);
    };
    const std::string formula =
        fmt::format("sqrt({} + {} + {}) - 0.6", part('x'), part('y'), part('z'));
    expect_colors(draw(*context, scene_of(scene_text(formula, three, ""))), 300,
                  [&](const Pixel& p) { return mean(three, p.position, gauss); });
}

TEST_P(ColoredPictures, AnExpressionHasEveryNameOfThePlace) {
    const std::string color =
        "[material]\ncolor = ['abs(nx)', 't + z^2*a', '0.25*(1 + mean_curvature)']\n"
        "[time]\nfps = 10\nframes = 9\n[parameters]\na = '0.5 + t'\n";
    const Picture picture = draw(*context, scene_of(sphere_scene + dark + color), 4); // t = 0.3
    expect_colors(
        picture, 500,
        [](const Pixel& p) {
            return glm::dvec3(std::abs(p.normal.x), 0.3 + p.position.z * p.position.z * 0.8, 0.5);
        },
        1e-4);
}

// Parts that are no expression of the place stay values over time.
TEST_P(ColoredPictures, PartsMayBeOfTheTimeAlone) {
    const std::string color = "[material]\ncolor = ['0.5*(1 + z)', { keys = [[0, 0.75]] }, "
                              "'0.25 + t']\n";
    expect_colors(
        draw(*context, scene_of(sphere_scene + dark + color)), 500,
        [](const Pixel& p) { return glm::dvec3(0.5 + 0.5 * p.position.z, 0.75, 0.25); }, 1e-5);
}

TEST_P(ColoredPictures, TheBackKeepsItsOwn) {
    const std::string color = "[material]\ncolor = ['x', 'y', 'z']\nback_color = [0.5, 0, 1]\n";
    const auto scene = [&](const char* formula) {
        return scene_of(sphere_scene + dark + color, {std::string("surface.formula=") + formula});
    };
    expect_colors(
        draw(*context, scene("x^2 + y^2 + z^2 - 1")), 500,
        [](const Pixel& p) { return p.position; }, 1e-5);
    expect_colors(
        draw(*context, scene("1 - x^2 - y^2 - z^2")), 500,
        [](const Pixel&) { return glm::dvec3(0.5, 0, 1); }, 1e-6);
}

// Where effects keep the surface, and mirrors ask for it again: its colour is the same.
TEST_P(ColoredPictures, EffectsShowItToo) {
    const std::vector<Element> two{{{-0.9, 0, 0}, red}, {{0.9, 0.1, 0}, blue}};
    for (const char* effect : {"[fog]\ndensity = 0\n", "[ground]\nheight = -9\n"}) {
        const auto scene =
            scene_of(scene_text(fmt::format("1 - sum(p, exp(2 - 2*{}))", distance), two, effect));
        ASSERT_TRUE(shader::assemble(scene).has(shader::Role::surface));
        expect_colors(draw(*context, scene), 300,
                      [&](const Pixel& p) { return mean(two, p.position, gauss); });
    }
    const auto mirror = scene_of(scene_text(fmt::format("1 - sum(p, exp(2 - 2*{}))", distance), two,
                                            "[material]\nreflection = 'self'\n"));
    EXPECT_GT(count(draw(*context, mirror), Verdict::hit), 300);
}

// Elements found by place: colours sum over the lists of cells, and over all where they weigh
// otherwise.
TEST_P(ColoredPictures, ManyElementsShowTheMeanOfThoseNearby) {
    std::vector<Element> many;
    for (int k = 0; k < 900; ++k) {
        const double z = -1 + 2 * (k + 0.5) / 900, a = 2.4 * k, r = std::sqrt(1 - z * z);
        many.push_back({1.5 * glm::dvec3(r * std::cos(a), r * std::sin(a), z),
                        glm::dvec3(k % 2, (k / 2) % 2, 0.5 + 0.5 * z)});
    }
    const auto narrow = [](double square) { return std::pow(std::max(0.0, 1 - 16 * square), 3); };
    const auto fading = [](double square) { return std::exp(-40 * square); };
    const auto wide = [](double square) { return std::exp(-square); };
    const std::string by_hat = fmt::format("0.3 - sum(p, max(0, 1 - 16*{})^3)", distance);
    const std::string by_gauss = fmt::format("0.3 - sum(p, exp(-40*{}))", distance);
    const auto by_place = [&](const std::string& text) {
        const auto scene = scene_of(text);
        EXPECT_TRUE(shader::array_with_grid(shader::assemble(scene)));
        return draw(*context, scene);
    };
    expect_colors(by_place(scene_text(by_hat, many, "")), 1000,
                  [&](const Pixel& p) { return mean(many, p.position, narrow); });
    expect_colors(by_place(scene_text(by_gauss, many, "")), 1000,
                  [&](const Pixel& p) { return mean(many, p.position, fading); });
    const auto ratio = [&](char part) {
        return fmt::format("'sum(p, {0}*exp(-{1}))/sum(p, exp(-{1}))'", part, distance);
    };
    expect_colors(by_place(scene_text(by_hat, many,
                                      fmt::format("[material]\ncolor = [{}, {}, {}]\n", ratio('r'),
                                                  ratio('g'), ratio('b')))),
                  1000, [&](const Pixel& p) { return mean(many, p.position, wide); });
}

TEST_P(ColoredPictures, WhatIsNoNumberIsCounted) {
    const std::string color = "[material]\ncolor = ['log(z)', 0, 0]\n";
    const Picture picture = draw(*context, scene_of(sphere_scene + dark + color));
    std::int64_t below = 0;
    for (std::size_t k = 0; k < picture.frame.find("R")->samples.size(); ++k) {
        below += Verdict(int(picture.frame.find("verdict")->samples[k])) == Verdict::hit &&
                 picture.frame.find("P.Z")->samples[k] < 0;
    }
    EXPECT_GT(below, 500);
    EXPECT_EQ(image::count_without_colour(picture.frame), below);
}

// The fingerprint of a frame covers what its colours are.
TEST_P(ColoredPictures, OtherValuesAreAnotherFingerprint) {
    const auto print = [&](const glm::dvec3& color) {
        const std::vector<Element> two{{{-0.9, 0, 0}, red}, {{0.9, 0.1, 0}, color}};
        const auto scene =
            scene_of(scene_text(fmt::format("1 - sum(p, exp(2 - 2*{}))", distance), two, ""));
        Renderer renderer(*context, scene, {16, 16, {}, {}});
        return renderer.prepare(scene, 1).fingerprint;
    };
    const std::string first = print(blue);
    EXPECT_EQ(print(blue), first);
    EXPECT_NE(print({0, 0, 0.999}), first);
}

TEST_P(ColoredPictures, FilesWithColoursNeedNoMore) {
    const image::TemporaryFolder folder;
    const std::string scene = fmt::format("[surface]\nformula = '1 - sum(p, exp(2 - 2*{}))'\n"
                                          "bounds = {{ sphere = 3 }}\n[camera]\n"
                                          "position = [1, 8, 2]\n[output]\nsize = [96, 64]\n"
                                          "[arrays.p]\nfile = 'p'\n"
                                          "columns = {{ cx = 'x', cy = 'y', cz = 'z' }}\n",
                                          "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)") +
                              dark;
    std::ofstream(folder / "scene.toml") << scene;
    const std::vector<Element> two{{{-0.9, 0, 0}, {1, 0.2, 0}}, {{0.9, 0.1, 0}, {0, 0.4, 1}}};
    const std::string header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                               "property float y\nproperty float z\n";
    const auto properties = [](const char* type, const char* r, const char* g, const char* b) {
        return fmt::format("property {0} {1}\nproperty {0} {2}\nproperty {0} {3}\nend_header\n",
                           type, r, g, b);
    };
    for (const std::string& file :
         {std::string("x,y,z,r,g,b\n-0.9,0,0,1,0.2,0\n0.9,0.1,0,0,0.4,1\n"),
          std::string("x,y,z,red,green,blue\n-0.9,0,0,255,51,0\n0.9,0.1,0,0,102,255\n"),
          header + properties("uchar", "red", "green", "blue") +
              "-0.9 0 0 255 51 0\n0.9 0.1 0 0 102 255\n",
          header + properties("ushort", "r", "g", "b") +
              "-0.9 0 0 65535 13107 0\n0.9 0.1 0 0 26214 65535\n",
          header + properties("float", "red", "green", "blue") +
              "-0.9 0 0 1 0.2 0\n0.9 0.1 0 0 0.4 1\n"}) {
        std::ofstream(folder / "p", std::ios::trunc) << file;
        const scene::Scene loaded = scene::load((folder / "scene.toml").string());
        SCOPED_TRACE(file);
        expect_colors(draw(*context, loaded), 300,
                      [&](const Pixel& p) { return mean(two, p.position, gauss); });
    }
}

} // namespace
} // namespace isomotion::render
