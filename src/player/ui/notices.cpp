#include "player/ui/notices.h"

#include <fmt/format.h>
#include <imgui.h>

#include "player/ui/shortcuts.h"
#include "player/ui/theme.h"

namespace isomotion::player {
namespace {

constexpr ImGuiWindowFlags card = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                  ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                  ImGuiWindowFlags_AlwaysAutoResize |
                                  ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// A compilation shorter than this is not worth a word.
constexpr double noticeable = 0.15;

} // namespace

void Notices::show(std::optional<std::chrono::steady_clock::time_point> compiling) {
    if (compiling) {
        const std::chrono::duration<double> since = std::chrono::steady_clock::now() - *compiling;
        if (since.count() > noticeable) show_progress(since.count());
    }
    if (!load_error.empty()) {
        show_error(load_error);
    } else if (!draw_error.empty()) {
        show_error(draw_error);
    }
    if (help) show_help();
}

void Notices::show_progress(double seconds) {
    const float unit = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({unit, unit});
    ImGui::SetNextWindowBgAlpha(0.9f);
    ImGui::Begin("progress", nullptr, card | ImGuiWindowFlags_NoInputs);
    ImGui::Text("compiling the scene's shader: %.1f s", seconds);
    ImGui::End();
}

void Notices::show_error(const std::string& text) {
    const float unit = ImGui::GetFontSize();
    const ImVec2 area = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({unit, unit});
    ImGui::SetNextWindowSizeConstraints({10 * unit, 0}, {area.x - 2 * unit, 0.6f * area.y});
    ImGui::SetNextWindowBgAlpha(0.94f);
    ImGui::Begin("error", nullptr, card);
    ImGui::PushTextWrapPos(std::min(48 * unit, area.x - 4 * unit));
    ImGui::PushStyleColor(ImGuiCol_Text, error_color());
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void Notices::show_help() {
    const ImVec2 area = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({area.x / 2, area.y / 2}, 0, {0.5f, 0.5f});
    ImGui::SetNextWindowFocus();
    ImGui::Begin("help", nullptr, card);
    ImGui::TextUnformatted("Keys and mouse");
    ImGui::Spacing();
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const Shortcut& shortcut : shortcuts()) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            if (shortcut.keys.empty()) {
                ImGui::Spacing();
                continue;
            }
            ImGui::TextUnformatted(shortcut.keys.begin(), shortcut.keys.end());
            ImGui::TableNextColumn();
            ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
            ImGui::TextUnformatted(shortcut.what.begin(), shortcut.what.end());
            ImGui::PopStyleColor();
        }
        ImGui::EndTable();
    }
    ImGui::Spacing();
    ImGui::TextDisabled("Escape or ? closes this");
    ImGui::End();
}

} // namespace isomotion::player
