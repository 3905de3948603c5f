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
void read_colors(std::optional<Section>& own, SurfaceParts& parts, MaterialParts& read,
                 TrackTable& tracks) {
    std::optional<Section> catalogue;
    if (parts.catalogue) catalogue = Section(*parts.catalogue, "").section("material");
    struct Found {
        const toml::node* node = nullptr;
        std::string key;
    };
    const auto find = [&](const std::string& name) {
        Found found;
        for (auto* section : {&own, &catalogue}) {
            const toml::node* node = *section ? (*section)->find(name) : nullptr;
            if (node && !found.node) found = {node, (*section)->dotted(name)};
        }
        return found;
    };
    if (const Found front = find("color"); front.node) {
        read.color = read_color(*front.node, front.key, parts, tracks);
    } else {
        read.color.tracks = tracks.add("material.color", 0.72, 0.32, 0.08);
    }
    read.color.is_given = own && own->has("color");
    Material& material = parts.surface.material;
    material.color = read.color.tracks;
    if (const Found back = find("back_color"); back.node)
        material.inside = tracks.add(back.key, read_vector(*back.node, back.key), back.node);
    if (catalogue) catalogue->refuse_rest();
}

// A model has keys that others lack.
void read_gloss(Section& section, Material& material, TrackTable& tracks) {
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
        fail(*section.find(std::string(key)), section.dotted(std::string(key)),
             fmt::format("{} is of model{} {}; this one is {}", key, models.size() > 1 ? "s" : "",
                         fmt::join(models, " and "),
                         keys::name(keys::model_words, material.model)));
    }
}

void read_glass(Section& section, Material& material, TrackTable& tracks) {
    if (!section.has("transmission")) {
        keys::for_each_row(keys::glass_keys, [&](const auto& row) {
            if (const toml::node* node = section.find(row.name)) {
                fail(*node, section.dotted(row.name),
                     fmt::format("{} is of matter that light goes through; give transmission = 1 "
                                 "as well",
                                 row.name));
            }
        });
        return;
    }
    read_keys(keys::glass_keys, section, material.glass.emplace(), tracks);
    if (material.reflection == Material::Reflection::none) return;
    fail(*section.find("reflection"), section.dotted("reflection"),
         "what light goes through mirrors what is around by its ior; leave reflection out, or "
         "transmission");
}

} // namespace

MaterialParts read_material(Section& document, SurfaceParts& parts, TrackTable& tracks) {
    MaterialParts read;
    Material& material = parts.surface.material;
    auto own = document.section("material");
    read_colors(own, parts, read, tracks);
    if (own) {
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

void make_paints(const MaterialParts& parts, SurfaceParts& surface) {
    Material& material = surface.surface.material;
    if (parts.colormap) material.paint = make_paint(*parts.colormap, surface);
    if (parts.contours) material.contours = make_contours(*parts.contours, surface);
    // Elements' colours are not asked for where a map colours the surface.
    if (!parts.colormap || parts.color.is_of_place())
        material.color_by_place = make_color(parts.color, surface);
}

std::vector<const formula::Paint*> paints_of(const Material& material) {
    std::vector<const formula::Paint*> paints;
    if (material.paint) paints.push_back(material.paint->value.get());
    if (material.color_by_place) paints.push_back(material.color_by_place.get());
    if (material.contours) paints.push_back(material.contours->value.get());
    return paints;
}

} // namespace isomotion::scene
