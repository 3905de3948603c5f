#include "app/topology_subject.h"

#include <stdexcept>

#include <fmt/format.h>

#include "scene/scene_at.h"
#include "scene/surfaces.h"
#include "topology/timeline/contact_words.h"

namespace isomotion::app {

Subject subject_of(const scene::Scene& scene, const std::string& surface,
                   const std::vector<std::string>& contact) {
    if (!contact.empty()) {
        const std::size_t first = scene::surface_named(scene, contact[0], "--contact");
        const std::size_t second = scene::surface_named(scene, contact[1], "--contact");
        if (first == second) {
            throw std::invalid_argument(
                fmt::format("--contact {0} {0}: name two surfaces of the scene", contact[0]));
        }
        return topology::subject_of(scene, first, second);
    }
    if (surface.empty()) return topology::subject_of(scene, 0);
    return topology::subject_of(scene, scene::surface_named(scene, surface, "--surface"));
}

std::vector<SolidChoice> parse_solids(const std::vector<std::string>& texts,
                                      const scene::Scene& scene) {
    std::vector<SolidChoice> choices;
    for (const std::string& text : texts) {
        const std::size_t equals = text.rfind('=');
        const bool is_named = equals != std::string::npos;
        const std::string name = is_named ? text.substr(0, equals) : "";
        const std::string side = is_named ? text.substr(equals + 1) : text;
        if (side != "negative" && side != "positive") {
            throw std::invalid_argument(fmt::format(
                "--solid {}: write negative, where F < 0 is the solid, or positive, where F > 0 "
                "is; for one of several surfaces NAME=negative",
                text));
        }
        if (is_named && scene.surfaces.size() == 1) {
            throw std::invalid_argument(
                fmt::format("--solid {}: the scene has one surface; write --solid {}", text, side));
        }
        if (is_named) scene::surface_named(scene, name, "--solid");
        choices.push_back(
            {name, side == "negative" ? topology::Side::negative : topology::Side::positive});
    }
    return choices;
}

void expect_searched(const Subject& subject, const std::vector<SolidChoice>& choices) {
    for (const SolidChoice& choice : choices) {
        const std::string& name = choice.surface;
        if (name.empty() || name == subject.first.surface.label) continue;
        if (subject.second && name == subject.second->surface.label) continue;
        throw std::invalid_argument(
            fmt::format("--solid {}: that surface is not searched", choice.surface));
    }
}

std::array<topology::Side, 2> solids_of(const Subject& subject,
                                        const std::vector<SolidChoice>& choices) {
    const auto solid = [&](const scene::OneSurface& one) {
        topology::Side side = topology::solid_side(one);
        for (const std::string& name : {std::string(), one.surface.label}) {
            for (const SolidChoice& choice : choices) {
                if (choice.surface == name) side = choice.side;
            }
        }
        return side;
    };
    const topology::Side first = solid(subject.first);
    return {first, subject.second ? solid(*subject.second) : first};
}

std::string solid_text(const Subject& subject, const std::array<topology::Side, 2>& solids) {
    const auto line = [](const scene::OneSurface& one, topology::Side side, bool is_named) {
        if (side == topology::Side::negative) return std::string();
        const std::string& name = one.surface.label;
        return fmt::format("{}the solid is F > 0; --solid {}negative takes F < 0\n",
                           is_named ? name + ": " : "", is_named ? name + "=" : "");
    };
    if (!subject.second) return line(subject.first, solids[0], false);
    return line(subject.first, solids[0], true) + line(*subject.second, solids[1], true);
}

std::string contact_text(const Subject& subject, const topology::TimelineRecord& record) {
    const scene::OneSurface& first = subject.first;
    const auto to_world = [&first](double time, const std::array<double, 3>& place) {
        const scene::SurfaceAt now = scene::surface_at(first, time);
        const glm::dvec3 at = now.placement.to_world({place[0], place[1], place[2]});
        return std::array{at.x, at.y, at.z};
    };
    return topology::contact_text({first.surface.label, subject.second->surface.label, to_world},
                                  record.timeline, record.header.fps);
}

} // namespace isomotion::app
