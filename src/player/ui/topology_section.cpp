#include "player/ui/topology_section.h"

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "player/ui/sections.h"
#include "player/ui/theme.h"
#include "scene/surfaces.h"

namespace isomotion::player {

void TopologySection::start(const LiveScene& scene) {
    failure_.clear();
    cancelled_ = false;
    const std::filesystem::path timeline = scene.timeline_file();
    std::vector<std::string> words{"topology", scene::reload_argument(scene.session.scene()),
                                   "--quiet", "-o", timeline.string()};
    for (const scene::Override& setting : scene.overrides()) {
        words.insert(words.end(), {"--set", setting});
    }
    if (scene.reach() == scene::Reach::anywhere) words.emplace_back("--allow-outside");
    try {
        if (timeline.has_parent_path()) {
            std::filesystem::create_directories(timeline.parent_path());
        }
        process_.emplace("/proc/self/exe", words);
    } catch (const std::exception& error) {
        failure_ = error.what();
    }
}

void TopologySection::attend() {
    if (!process_ || !process_->ended()) return;
    if (!process_->succeeded() && !cancelled_) {
        const std::string words = process_->last_words(6);
        failure_ =
            words.empty() ? fmt::format("topology ended with {}", process_->ending()) : words;
    }
    process_.reset();
}

void TopologySection::show(const LiveScene& scene, bool& rings) {
    if (!heading("Topology")) return;
    const auto& markers = scene.markers();
    const auto count = [&](TimelineMarker::Kind kind) {
        return std::ranges::count(markers, kind, &TimelineMarker::kind);
    };
    ImGui::PushTextWrapPos(0);
    const auto events = count(TimelineMarker::Kind::event),
               unresolved = count(TimelineMarker::Kind::unresolved);
    if (events + unresolved > 0) {
        ImGui::Text("%td events on the timeline", events);
        if (unresolved > 0) ImGui::Text("%td places where something is not told", unresolved);
        ImGui::Checkbox("rings where they are (E)", &rings);
    }
    if (!scene.refusal().empty()) ImGui::TextDisabled("%s", scene.refusal().c_str());
    if (!failure_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, error_color());
        ImGui::TextUnformatted(failure_.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopTextWrapPos();
    if (process_) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("finding events ...");
        ImGui::SameLine();
        if (ImGui::Button("cancel", {-1, 0})) {
            cancelled_ = true;
            process_->interrupt();
        }
        return;
    }
    if (scene.session.scene().surfaces.size() > 1) {
        ImGui::PushTextWrapPos(0);
        for (const std::string& name : scene::surface_names(scene.session.scene())) {
            ImGui::TextDisabled("isomotion topology %s --surface %s -o %s", scene.file().c_str(),
                                name.c_str(), timeline_path(scene.session.scene(), name).c_str());
        }
        ImGui::PopTextWrapPos();
        return;
    }
    if (ImGui::Button("find events", {-1, 0})) {
        start(scene);
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("isomotion topology, which may take minutes; writes\n%s",
                          scene.timeline_file().c_str());
    }
}

} // namespace isomotion::player
