// Scenes written as text, and texts taken apart into lines.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <fmt/format.h>

#include "scene/reading/load.h"
#include "shader/assemble.h"

namespace isomotion::shader {

// Shaders are read from the source tree, wherever the test was built.
inline void use_shaders_of_source_tree() {
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
}

inline scene::Scene scene_of(const std::string& text) {
    const auto file =
        std::filesystem::temp_directory_path() / fmt::format("isomotion-shader-{}.toml", getpid());
    std::ofstream(file) << text;
    scene::Scene scene = scene::load(file.string());
    std::filesystem::remove(file);
    return scene;
}

// How a page is drawn.
inline const Drawing on_page{.platform = Platform::webgl, .writes_buffers = false};

// The text of the pass with that role.
inline const std::string& text_of(const Passes& passes, Role role, int level = 0) {
    return passes.at(role, level).text;
}

// The texts of all shaders together.
inline std::string all_texts(const Passes& passes) {
    std::string all;
    for (const Pass& pass : passes.list) all += pass.vertex + pass.text;
    return all;
}

inline const std::vector<std::string> every_method{"marching", "amp-sign", "amp-taylor", "hermite",
                                                   "interval", "affine",   "sphere"};
inline const std::vector<std::string> every_bounds{"{ sphere = 2 }",
                                                   "{ box = [[-1,-1,-1],[1,2,1]] }"};
inline const std::vector<Channel> every_channel{Channel::depth, Channel::normal, Channel::position,
                                                Channel::verdict, Channel::evaluations};

// Colours by place, each with the files that another leaves out.
inline const std::vector<std::string> every_paint{
    "[material.colormap]\nvalue = 'nz*t + evaluations'\nrange = [-1, 1]\n",
    "[material.colormap]\nvalue = 'exp(x) - mean_curvature'\nrange = ['t - 1', 1]\n"
    "map = 'blue-orange'\n",
    "[material]\ncolor = ['nx*t + evaluations', 'abs(y)', 0.5]\n",
    "[material]\ncolor = ['exp(x) - gaussian_curvature', 't', 0]\nback_color = [1, 1, 1]\n"};

// Effects, so that all files are called for.
inline const std::vector<std::string> every_effect{
    "[[lights]]\ndirection = [1, 0, 0]\nshadow = true\n[ground]\nheight = -1\n"
    "[fog]\ndensity = 0.1\n[occlusion]\n[ambient]\ntop = [1, 1, 1]\n",
    "[[lights]]\nposition = [2, 0, 0]\n[material]\nmodel = 'ggx'\nreflection = 'self'\n"
    "[environment]\nmap = 'studio.exr'\n",
    "[material]\nmodel = 'blinn-phong'\nreflection = 'sky'\n"
    "[output]\nbackground = { top = [0, 0, 1], bottom = [1, 1, 1] }\n",
    "[[sections]]\nnormal = [1, 0, 0]\n[material]\nback_color = [1, 0, 0]\n"
    "[material.contours]\nvalue = 'z'\nevery = 0.1\n",
    "[[sections]]\nnormal = [1, 0, 0]\n[[sections]]\nsphere = 1\n[occlusion]\n"
    "[material]\nreflection = 'self'\n[[lights]]\ndirection = [1, 0, 0]\nshadow = true\n"
    "[material.colormap]\nvalue = 'mean_curvature'\nrange = [-1, 1]\n"};

// Glass, over a ground and in the open.
inline const std::vector<std::string> every_glass{
    "[material]\ntransmission = 1\n[ground]\nheight = -1\n[[lights]]\ndirection = [1, 0, 1]\n"
    "shadow = true\n",
    "[material]\nmodel = 'ggx'\nmetallic = 0.5\ntransmission = 't/2'\nior = 1.3\nabsorption = [1, "
    "'t', 0]\n[environment]\n"
    "map = 'studio.exr'\n"};

// A mirror, glass, plain matter and water, among each other; `value` is in all numbers.
inline std::string glass_among_others(const std::string& value) {
    const auto surface = [&](const std::string& formula, const std::string& material) {
        return fmt::format(
            "[[surfaces]]\nformula = '{0}'\nbounds = {{ sphere = 2 }}\nparameters = {{ r "
            "= {1} }}\nmaterial = {{ {2}, color = [{1}, 1, 0] }}\n",
            formula, value, material);
    };
    const auto glass = [&](const std::string& more) {
        return fmt::format("transmission = {0}, ior = {0}, absorption = [{0}, 0, 0]{1}", value,
                           more);
    };
    return surface("x^2 + y^2 + z^2 - r", "reflection = 'self'") +
           surface("x*y*z - r", glass(", model = 'ggx', metallic = " + value)) +
           surface("x + y + z - r", "back_color = [1, 1, 1]") +
           surface("x + y*r", glass(", priority = 2")) +
           fmt::format("[[lights]]\ndirection = [{0}, 1, 1]\nshadow = true\n[ground]\nheight = "
                       "-{0}\n[[sections]]\nnormal = [{0}, 1, 0]\n",
                       value);
}

inline std::string surface_text(const std::string& formula,
                                const std::string& bounds = every_bounds[0],
                                const std::string& method = "amp-sign") {
    return fmt::format("[surface]\nformula = '''{}'''\nbounds = {}\n[isolation]\nmethod = '{}'\n",
                       formula, bounds, method);
}

// A formula of several thousand operations.
// Its terms stay as they are written: no more than one is in each sum, so none is repeated.
inline std::string long_formula() {
    std::string text = "s = x^2 + y^2 + z^2 - 1; ";
    for (int k = 1; k <= 250; ++k) text += fmt::format("s = 1.001*(s + 1e-5*sin({}*x + y)*z); ", k);
    return text + "s";
}

// A formula with kinks that is run from tapes, and repeats no operand of a min either.
inline std::string many_balls() {
    std::string text = "m = x^2 + y^2 + z^2 - 1; ";
    for (int k = 0; k < 200; ++k)
        text += fmt::format("m = 1.001*min(m, (x - {}/7)^2 + y^2 + z^2 - 1); ", k);
    return text + "m";
}

// Gaussian balls.
inline std::string
blobs_text(int count, const std::string& bounds = every_bounds[0],
           const std::string& method = "amp-sign",
           const std::string& term = "exp(-20*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))") {
    return surface_text("sum(blobs, " + term + ") - 1", bounds, method) +
           fmt::format("[arrays.blobs]\ncount = {}\ncx = 'random(i, 0)'\ncy = 'random(i, 1)'\n"
                       "cz = 'random(i, 2)'\n",
                       count);
}

using Lines = std::multiset<std::string>;

inline Lines lines_of(const std::string& text) {
    Lines lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.insert(line);
    return lines;
}

// The lines that `a` has and `b` does not have.
inline Lines without(const Lines& a, const Lines& b) {
    Lines rest;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(rest, rest.end()));
    return rest;
}

inline int occurrences(const std::string& text, const std::string& part) {
    int count = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
    return count;
}

// The folder of shaders in the source tree, and the names of all files in it.
inline const std::filesystem::path shader_folder{ISOMOTION_SOURCE_DIR "/shaders"};

inline std::set<std::string> shader_files() {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shader_folder)) {
        if (!entry.is_regular_file()) continue;
        names.insert(entry.path().lexically_relative(shader_folder).string());
    }
    return names;
}

// Surfaces without effects, which are drawn over each other.
inline scene::Scene two_plain_surfaces(const std::string& value) {
    const std::string one =
        "[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - r\"\nbounds = { sphere = 2 "
        "}\nparameters = { r = " +
        value + " }\nmaterial = { color = [" + value + ", 1, 0] }\n";
    return scene_of(one + one);
}

inline scene::Scene proved_surfaces(const std::string& value) {
    scene::Scene scene = two_plain_surfaces(value);
    scene.surfaces[0].isolation.certify = scene.surfaces[1].isolation.certify = true;
    return scene;
}

} // namespace isomotion::shader
