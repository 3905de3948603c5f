#include "scene/reading/material.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "formula/graph/vocabulary.h"
#include "scene/limits.h"

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

Model read_model(Section& section) {
    const auto text = section.text("model");
    if (!text) return Model::lambert;
    if (const auto model = parse_model(*text)) return *model;
    std::vector<std::string> known;
    for (const auto& entry : model_names) known.emplace_back(entry.name);
    const std::string near = base::nearest_name(*text, known);
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

// Light goes in where `transmission` says so; the other keys are of what it goes through.
void read_glass(Section& section, Material& material, TrackTable& tracks) {
    const toml::node* transmission = section.find("transmission");
    for (const char* name : {"ior", "absorption", "depth", "priority"}) {
        const toml::node* node = section.find(name);
        if (!node || transmission) continue;
        fail(*node, section.dotted(name),
             fmt::format("{} is of matter that light goes through; give transmission = 1 as well",
                         name));
    }
    if (!transmission) return;
    Glass& glass = material.glass.emplace();
    const auto add = [&](const char* name, double standard) {
        return tracks.add(section.dotted(name), section.track(name).value_or(standard),
                          section.find(name));
    };
    glass.transmission = add("transmission", 1);
    glass.ior = add("ior", 1.5); // glass; water has 1.33
    const toml::node* absorption = section.find("absorption");
    glass.absorption = absorption ? tracks.add(section.dotted("absorption"),
                                               *section.vector("absorption"), absorption)
                                  : tracks.add(section.dotted("absorption"), 0, 0, 0);
    glass.depth = section.integer("depth", 0, limits::glass_depth).value_or(glass.depth);
    glass.priority =
        section.integer("priority", -limits::priority, limits::priority).value_or(glass.priority);
    if (material.reflection == Material::Reflection::none) return;
    fail(*section.find("reflection"), section.dotted("reflection"),
         "what light goes through mirrors what is around by its ior; leave reflection out, or "
         "transmission");
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

MaterialParts read_material(Section& document, SurfaceParts& parts, TrackTable& tracks) {
    MaterialParts read;
    Material& material = parts.surface.material;
    auto own = document.section("material");
    read_colors(own, parts, read, tracks);
    if (own) {
        if (const toml::node* cap = own->find("cap_color"))
            material.cap = tracks.add("material.cap_color", *own->vector("cap_color"), cap);
        material.model = read_model(*own);
        read_gloss(*own, material, tracks);
        read_reflection(*own, material);
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
