#include "player/ui/theme.h"

#include <filesystem>

#include <imgui.h>

namespace isomotion::player {
namespace {

constexpr float font_size = 15;

ImVec4 grey(float level, float opacity = 1) {
    return {level, level * 1.01f, level * 1.04f, opacity};
}
const ImVec4 accent{0.36f, 0.62f, 0.92f, 1};
ImVec4 of_accent(float opacity) { return {accent.x, accent.y, accent.z, opacity}; }

void load_font(float scale) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    // Latin with accents, Greek (parameters), arrows and the signs that the panels write.
    static const ImWchar ranges[] = {0x20,   0x24f,  0x370,  0x3ff,  0x2010, 0x2027, 0x2030,
                                     0x205e, 0x2190, 0x21ff, 0x2200, 0x22ff, 0};
    for (const char* file : {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                             "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                             "/usr/share/fonts/TTF/DejaVuSans.ttf",
                             "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                             "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"}) {
        std::error_code error;
        if (!std::filesystem::is_regular_file(file, error)) continue;
        if (fonts.AddFontFromFileTTF(file, font_size * scale, nullptr, ranges)) return;
    }
    ImFontConfig plain;
    plain.SizePixels = 13 * scale;
    fonts.AddFontDefault(&plain);
}

} // namespace

void apply_theme(float scale) {
    load_font(scale);
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    style.WindowPadding = {14, 12};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 7};
    style.ItemInnerSpacing = {6, 5};
    style.IndentSpacing = 14;
    style.ScrollbarSize = 10;
    style.GrabMinSize = 9;
    style.WindowBorderSize = 0;
    style.FrameBorderSize = 0;
    style.PopupBorderSize = 1;
    style.WindowRounding = 0;
    style.ChildRounding = 4;
    style.FrameRounding = 4;
    style.PopupRounding = 5;
    style.GrabRounding = 4;
    style.ScrollbarRounding = 5;
    ImVec4* colors = style.Colors;
    colors[ImGuiCol_Text] = grey(0.88f);
    colors[ImGuiCol_TextDisabled] = grey(0.56f);
    colors[ImGuiCol_WindowBg] = grey(0.125f);
    colors[ImGuiCol_ChildBg] = grey(0.125f, 0);
    colors[ImGuiCol_PopupBg] = grey(0.155f);
    colors[ImGuiCol_Border] = grey(0.26f);
    colors[ImGuiCol_FrameBg] = grey(0.19f);
    colors[ImGuiCol_FrameBgHovered] = grey(0.235f);
    colors[ImGuiCol_FrameBgActive] = grey(0.27f);
    colors[ImGuiCol_Button] = grey(0.205f);
    colors[ImGuiCol_ButtonHovered] = grey(0.27f);
    colors[ImGuiCol_ButtonActive] = of_accent(0.65f);
    colors[ImGuiCol_Header] = grey(0.165f);
    colors[ImGuiCol_HeaderHovered] = grey(0.215f);
    colors[ImGuiCol_HeaderActive] = grey(0.25f);
    colors[ImGuiCol_SliderGrab] = of_accent(0.85f);
    colors[ImGuiCol_SliderGrabActive] = accent;
    colors[ImGuiCol_CheckMark] = accent;
    colors[ImGuiCol_Separator] = grey(0.21f);
    colors[ImGuiCol_ScrollbarBg] = grey(0.125f, 0);
    colors[ImGuiCol_ScrollbarGrab] = grey(0.28f);
    colors[ImGuiCol_TextSelectedBg] = of_accent(0.4f);
    colors[ImGuiCol_PlotHistogram] = accent;
    colors[ImGuiCol_NavHighlight] = of_accent(0);
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

glm::vec3 background_color() { return {0.075f, 0.076f, 0.08f}; }

unsigned accent_color() { return ImGui::GetColorU32(accent); }
unsigned text_color() { return ImGui::GetColorU32(grey(0.9f)); }
unsigned faint_color() { return ImGui::GetColorU32(grey(0.42f)); }
unsigned error_color() { return ImGui::GetColorU32({0.95f, 0.45f, 0.38f, 1}); }

} // namespace isomotion::player
