#include "scene/reading/pov_look.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/reading/pov_colors.h"

namespace isomotion::scene {
namespace {

bool is_look(const PovWord& word) {
    return word.is("texture") || word.is("pigment") || word.is("finish") || word.is("material");
}

// Words that stand alone, or with "on" or "off", and change nothing that is read.
bool is_switch(const PovWord& word) {
    static constexpr std::string_view words[] = {
        "no_shadow", "no_image",          "no_reflection", "no_radiosity", "hollow",
        "sturm",     "double_illuminate", "uv_mapping",    "hierarchy",    "all_intersections"};
    return word.kind == PovWord::Kind::name && std::ranges::count(words, word.text) > 0;
}

} // namespace

double PovLook::mirrored() const { return std::clamp(0.3 * highlight, 0.0, 0.9); }

void PovLook::take(const PovLook& known) {
    if (known.color) {
        color = known.color;
        is_clear = known.is_clear;
    }
    if (known.highlight > 0) {
        highlight = known.highlight;
        shininess = known.shininess;
    }
    if (known.diffuse != PovLook{}.diffuse) diffuse = known.diffuse;
}

std::string PovLook::text() const {
    std::string all = fmt::format("{} {}", highlight, shininess);
    if (!color) return all;
    for (const PovNumber& part : *color) all += " " + part.text;
    return all;
}

bool PovLooks::read(PovCursor& at, PovLook& look) {
    const PovWord word = at.now();
    if (word.is("pigment")) {
        at.take();
        read_pigment(at, look);
    } else if (word.is("finish")) {
        at.take();
        read_finish(at, look);
    } else if (word.is("texture") || word.is("material")) {
        at.take();
        at.expect("{", word.text);
        const PovDepth within(depth_, at, word.text, "textures");
        while (!at.take_if("}")) {
            if (take_declared(at, look) || read(at, look)) continue;
            at.fail(word.text, fmt::format("'{}' is not read", at.now().text));
        }
    } else if (word.is("normal") || word.is("interior") || word.is("photons")) {
        at.take();
        at.skip_group(word.text);
    } else if (is_switch(word)) {
        at.take();
        if (at.now().is("on") || at.now().is("off")) at.take();
    } else {
        return false;
    }
    return true;
}

bool PovLooks::declare(const std::string& name, PovCursor& at) {
    if (!is_look(at.now())) return false;
    PovLook look;
    read(at, look);
    declared_[name] = look;
    return true;
}

bool PovLooks::take_declared(PovCursor& at, PovLook& look) {
    const auto found = declared_.find(at.now().text);
    if (found == declared_.end()) return false;
    at.take();
    look.take(found->second);
    return true;
}

void PovLooks::read_pigment(PovCursor& at, PovLook& look) {
    const std::size_t begin = at.place();
    at.expect("{", "pigment");
    if (!take_declared(at, look)) {
        if (!values_->is_color(at.now()))
            at.fail("pigment", "its pattern is not read; write pigment { color rgb <1, 0, 0> }");
        PovValue color = values_->value(at, "pigment");
        if (color.size() == 1) color.resize(3, color[0]);
        if (color.size() < 3) at.fail("pigment", "needs a colour of three numbers: rgb <1, 0, 0>");
        color.resize(5, PovNumber::of(0));
        for (int part = 0; (part = pov_color_part(at.now().text)) >= 0;) {
            at.take();
            color[std::size_t(part)] = values_->number(at, "pigment");
        }
        // All light passes if none is held back, nor coloured: a red filter is seen.
        const auto is_one = [](const PovNumber& part) { return part.value == 1.0; };
        const auto &filter = color[3], &transmit = color[4];
        look.is_clear = is_one(transmit) ||
                        (is_one(filter) && std::all_of(color.begin(), color.begin() + 3, is_one));
        color.resize(3);
        look.color = color;
    }
    at.go_to(begin);
    at.skip_group("pigment");
}

void PovLooks::read_finish(PovCursor& at, PovLook& look) {
    at.expect("{", "finish");
    while (!at.take_if("}")) {
        if (at.at_end()) at.fail("finish", "its braces do not close");
        if (take_declared(at, look)) continue;
        const PovWord word = at.take();
        if (word.is("diffuse")) {
            look.diffuse = values_->constant(at, word.text);
        } else if (word.is("phong") || word.is("specular")) {
            look.highlight = values_->constant(at, word.text);
        } else if (word.is("phong_size")) {
            look.shininess = values_->constant(at, word.text);
        } else if (word.is("roughness")) {
            look.shininess = 1 / std::max(values_->constant(at, word.text), 1e-4);
        } else if (at.now().is("{")) {
            at.skip_group("finish");
        }
    }
}

} // namespace isomotion::scene
