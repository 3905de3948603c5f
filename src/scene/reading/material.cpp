#include "scene/reading/material.h"

#include <algorithm>

#include <fmt/format.h>

#include "formula/graph/vocabulary.h"

namespace isomotion::scene {
namespace {

using Model = Material::Model;

// An animated value of a model, and its default.
struct Gloss {
    Model model;
    const char* name;
    std::optional<TrackId> Material::*track;
    double standard;
};

constexpr Gloss gloss_keys[] = {
    {Model::blinn_phong, "shininess", &Material::shininess, 50},
    {Model::blinn_phong, "specular", &Material::specular, 0.2},
    {Model::ggx, "roughness", &Material::roughness, 0.4},
    {Model::ggx, "metallic", &Material::metallic, 0},
    {Model::ggx, "specular", &Material::specular, 0.04}, // glass and most plastics
};

// The scene's colours, else the catalogue's.
void read_colors(std::optional<Section>& own, const SurfaceParts& parts, Material& material,
                 TrackTable& tracks) {
    std::optional<Section> catalogue;
    if (parts.catalogue) catalogue = Section(*parts.catalogue, "").section("material");
    const auto color = [&](const std::string& name) -> std::optional<Vec3Track> {
        std::optional<Vec3Track> found;
        for (auto* section : {&own, &catalogue}) {
            const toml::node* node = *section ? (*section)->find(name) : nullptr;
            if (node && !found) {
                found = tracks.add((*section)->dotted(name), *(*section)->vector(name), node);
            }
        }
        return found;
    };
    const auto front = color("color");
    material.color = front ? *front : tracks.add("material.color", 0.72, 0.32, 0.08);
    material.inside = color("back_color");
    if (catalogue) catalogue->refuse_rest();
}

Model read_model(Section& section) {
    const auto text = section.text("model");
    if (!text) return Model::lambert;
    if (const auto model = parse_model(*text)) return *model;
    std::vector<std::string> known;
    for (const auto& entry : model_names) known.emplace_back(entry.name);
    const std::string near = formula::nearest_name(*text, known);
    fail(*section.find("model"), section.dotted("model"),
         fmt::format("there is no model '{}'; {}known: {}", *text,
                     near.empty() ? "" : fmt::format("did you mean '{}'? ", near),
                     fmt::join(known, ", ")));
}

void read_gloss(Section& section, Material& material, TrackTable& tracks) {
    for (const Gloss& key : gloss_keys) {
        if (key.model != material.model) continue;
        const std::string name = section.dotted(key.name);
        material.*key.track = tracks.add(name, section.track(key.name).value_or(key.standard),
                                         section.find(key.name));
    }
    for (const Gloss& key : gloss_keys) {
        const toml::node* node = section.find(key.name);
        if (!node || material.*key.track) continue;
        std::vector<std::string_view> owners;
        for (const Gloss& other : gloss_keys) {
            if (other.track == key.track) owners.push_back(name(other.model));
        }
        fail(*node, section.dotted(key.name),
             fmt::format("{} is of model{} {}; this one is {}", key.name,
                         owners.size() > 1 ? "s" : "", fmt::join(owners, " and "),
                         name(material.model)));
    }
}

void read_reflection(Section& section, Material& material) {
    using Reflection = Material::Reflection;
    const auto text = section.text("reflection");
    if (!text) return;
    if (*text != "sky" && *text != "self") {
        fail(*section.find("reflection"), section.dotted("reflection"),
             fmt::format("there is no reflection '{}'; known: sky, self", *text));
    }
    material.reflection = *text == "sky" ? Reflection::sky : Reflection::self;
}

} // namespace

Material read_material(Section& document, const SurfaceParts& parts, TrackTable& tracks,
                       std::optional<PaintParts>& painted) {
    Material material;
    auto own = document.section("material");
    read_colors(own, parts, material, tracks);
    if (own) {
        material.model = read_model(*own);
        read_gloss(*own, material, tracks);
        read_reflection(*own, material);
        if (auto paint = own->section("colormap")) painted = read_paint(*paint, tracks);
        own->refuse_rest();
    }
    return material;
}

} // namespace isomotion::scene
