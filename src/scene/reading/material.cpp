#include "scene/reading/material.h"

#include <map>

#include <fmt/format.h>

#include "formula/graph/vocabulary.h"
#include "scene/key_tables.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {
namespace {

using Model = Material::Model;

// The scene's colours, else the catalogue's.
void read_colors(std::optional<Section>& own, std::optional<Section>& catalogue,
                 SurfaceParts& parts, MaterialParts& read, TrackTable& tracks) {
    const auto section_with = [&](const char* name) -> Section* {
        for (auto* section : {&own, &catalogue}) {
            if (*section && (*section)->has(name)) return &**section;
        }
        return nullptr;
    };
    Material& material = parts.surface.material;
    Section* given = section_with("color");
    if (given) {
        const toml::node& node = *given->find("color");
        given->attempt(
            "color", [&] { read.color = read_color(node, given->dotted("color"), parts, tracks); });
    }
    if (!given || given->is_wrong("color"))
        read.color.tracks = tracks.add("material.color", 0.72, 0.32, 0.08);
    read.color.is_given = own && own->has("color");
    material.color = read.color.tracks;
    if (Section* section = section_with("back_color"))
        read_keys(keys::color_keys, *section, material, tracks);
}

// A model has keys that others lack.
void read_gloss(Section& section, Material& material, TrackTable& tracks) {
    if (section.is_wrong("model")) {
        keys::for_each_model([&](Model, const auto& table) { pass_over(table, section); });
        return;
    }
    keys::for_each_model([&](Model model, const auto& table) {
        if (model == material.model) read_keys(table, section, material, tracks);
    });
    std::map<std::string_view, std::vector<std::string_view>> owners;
    keys::for_each_model([&](Model model, const auto& table) {
        keys::for_each_row(table, [&](const auto& row) {
            if (!section.find(row.name) || material.*row.track) return;
            owners[row.name].push_back(keys::name(keys::model_words, model));
        });
    });
    for (const auto& [key, models] : owners) {
        section.tell(std::string(key),
                     fmt::format("{} is of model{} {}; this one is {}", key,
                                 models.size() > 1 ? "s" : "", fmt::join(models, " and "),
                                 keys::name(keys::model_words, material.model)));
    }
}

void read_glass(Section& section, Material& material, TrackTable& tracks) {
    if (!section.has("transmission")) {
        keys::for_each_row(keys::glass_keys, [&](const auto& row) {
            if (section.find(row.name)) {
                section.tell(
                    row.name,
                    fmt::format("{} is of matter that light goes through; give transmission = 1 "
                                "as well",
                                row.name));
            }
        });
        return;
    }
    read_keys(keys::glass_keys, section, material.glass.emplace(), tracks);
    if (material.reflection == Material::Reflection::none) return;
    section.tell(
        "reflection",
        "what light goes through mirrors what is around by its ior; leave reflection out, or "
        "transmission");
}

} // namespace

MaterialParts read_material(Section& sections, SurfaceParts& parts, TrackTable& tracks) {
    MaterialParts read;
    Material& material = parts.surface.material;
    auto own = sections.section("material");
    std::optional<Section> catalogue;
    if (parts.catalogue)
        catalogue = Section(*parts.catalogue, "", sections.mistakes()).section("material");
    read_colors(own, catalogue, parts, read, tracks);
    if (catalogue) {
        pass_over(keys::color_keys, *catalogue);
        catalogue->refuse_rest();
    }
    if (own) {
        pass_over(keys::color_keys, *own);
        read_keys(keys::cap_keys, *own, material, tracks);
        read_keys(keys::material_keys, *own, material, tracks);
        read_gloss(*own, material, tracks);
        read_glass(*own, material, tracks);
        if (auto paint = own->section("colormap")) read.colormap = read_paint(*paint, tracks);
        if (auto lines = own->section("contours")) read.contours = read_contours(*lines, tracks);
        own->refuse_rest();
    }
    return read;
}

void make_paints(const MaterialParts& parts, SurfaceParts& surface, MistakeList& mistakes) {
    Material& material = surface.surface.material;
    if (parts.colormap) {
        material.paint = parts.colormap->paint;
        if (parts.colormap->value)
            mistakes.attempt([&] { material.paint = make_paint(*parts.colormap, surface); });
    }
    if (parts.contours) {
        material.contours = parts.contours->contours;
        if (parts.contours->value)
            mistakes.attempt([&] { material.contours = make_contours(*parts.contours, surface); });
    }
    // Elements' colours are not asked for where a map colours the surface.
    if (!parts.colormap || parts.color.is_of_place())
        mistakes.attempt([&] { material.color_by_place = make_color(parts.color, surface); });
}

std::vector<const formula::Paint*> paints_of(const Material& material) {
    std::vector<const formula::Paint*> paints;
    const auto add = [&](const std::shared_ptr<const formula::Paint>& paint) {
        if (paint) paints.push_back(paint.get()); // none whose expression is wrong
    };
    if (material.paint) add(material.paint->value);
    add(material.color_by_place);
    if (material.contours) add(material.contours->value);
    return paints;
}

} // namespace isomotion::scene
