#include "player/ui/sections.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "player/ui/theme.h"
#include "player/ui/widget_rects.h"

namespace isomotion::player {
namespace {

// The width of the column of names.
float name_width() { return 6.6f * ImGui::GetFontSize(); }

// The width of the column of values beside sliders.
float value_width() { return 4.2f * ImGui::GetFontSize(); }

// A slider of a row(), with room for its value on the right: under the knob nobody could read it.
// value_beside() writes it, once what is to be asked of the slider is asked.
template<class Number>
bool slider(const char* id, ImGuiDataType type, Number& value, Number least, Number most,
            const char* format, ImGuiSliderFlags flags, float less = 0) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - less - value_width());
    // What is typed after Ctrl + click stands in the slider itself.
    const bool is_typing = ImGui::GetIO().WantTextInput;
    const ImU32 text = is_typing ? ImGui::GetColorU32(ImGuiCol_Text) : IM_COL32_BLACK_TRANS;
    ImGui::PushStyleColor(ImGuiCol_Text, text);
    const bool touched = ImGui::SliderScalar(id, type, &value, &least, &most, format, flags);
    ImGui::PopStyleColor();
    return touched;
}

void value_beside(const std::string& value, float less = 0) {
    const float begin =
        ImGui::GetWindowContentRegionMax().x - less - ImGui::CalcTextSize(value.c_str()).x;
    ImGui::SameLine();
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), begin));
    ImGui::TextUnformatted(value.c_str());
}

void color_line(Rgb color, const std::string& text) {
    const float side = 0.7f * ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float down = 0.2f * ImGui::GetFontSize();
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + down},
                                              {at.x + side, at.y + down + side},
                                              IM_COL32(color[0], color[1], color[2], 255), 2);
    ImGui::Dummy({side, side});
    ImGui::SameLine();
    ImGui::TextUnformatted(text.c_str());
}

std::string percent(std::int64_t part, std::int64_t whole) {
    if (whole == 0) return "-";
    const double p = 100.0 * double(part) / double(whole);
    return part > 0 && p < 0.01 ? fmt::format("{} px", part) : fmt::format("{:.2f} %", p);
}

void heat_legend(double end) {
    const float width = ImGui::GetContentRegionAvail().x, height = 0.7f * ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    constexpr int bands = 32;
    for (int k = 0; k < bands; ++k) {
        const Rgb color = heat((k + 0.5) / bands);
        ImGui::GetWindowDrawList()->AddRectFilled(
            {at.x + width * float(k) / bands, at.y},
            {at.x + width * float(k + 1) / bands, at.y + height},
            IM_COL32(color[0], color[1], color[2], 255));
    }
    ImGui::Dummy({width, height});
    ImGui::TextDisabled("0");
    const std::string most = fmt::format("{:g} evaluations", end);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(most.c_str()).x);
    ImGui::TextDisabled("%s", most.c_str());
}

void normal_legend() { ImGui::TextDisabled("x, y, z of the normal as red, green, blue"); }

void difference_legend(const Difference& found, const RayCounts& left, const RayCounts& right) {
    const std::int64_t all =
        found.both_hit + found.both_miss + found.only_first + found.only_second + found.other;
    color_line(
        agree_hit,
        fmt::format("agree: {}", percent(found.both_hit + found.both_miss - found.apart, all)));
    color_line(far_apart, fmt::format("at other depths: {}", percent(found.apart, all)));
    color_line(first_alone,
               fmt::format("hit by the first alone: {}", percent(found.only_first, all)));
    color_line(second_alone,
               fmt::format("hit by the second alone: {}", percent(found.only_second, all)));
    if (found.other > 0) color_line(other_pair, fmt::format("other: {}", found.other));
    const auto each = [](const RayCounts& tally) {
        return fmt::format("{:.1f} ms, {:.1f} evaluations a ray", 1e3 * tally.drawing.count(),
                           double(tally.evaluations) /
                               double(std::max<std::int64_t>(1, tally.rays())));
    };
    ImGui::TextDisabled("first: %s", each(left).c_str());
    ImGui::TextDisabled("second: %s", each(right).c_str());
}

bool method_combo(const char* id, scene::Method& method) {
    bool changed = false;
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo(id, std::string(scene::name(method)).c_str(),
                           ImGuiComboFlags_HeightLarge)) {
        return false;
    }
    for (const auto& entry : scene::method_traits) {
        if (ImGui::Selectable(std::string(entry.name).c_str(), entry.method == method)) {
            method = entry.method;
            changed = true;
        }
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(entry.summary).c_str());
    }
    ImGui::EndCombo();
    return changed;
}

// A slider for a length or a threshold: over six decades about the scene's own.
bool magnitude(const char* name, double& value, double own) {
    row(name);
    const double middle = own > 0 ? own : 1e-2;
    const double least = middle * 1e-3, most = middle * 1e3;
    double wanted = value;
    const bool touched =
        slider(fmt::format("##{}", name).c_str(), ImGuiDataType_Double, wanted, least, most, "%.3g",
               ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    value_beside(fmt::format("{:.3g}", wanted));
    if (!touched || !(wanted > 0)) return false; // a NaN can be typed
    value = wanted;
    return true;
}

bool integer(const char* name, int& value, int least, int most, bool logarithmic = false) {
    row(name);
    const auto flags = ImGuiSliderFlags_AlwaysClamp |
                       (logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    const bool touched = slider(fmt::format("##{}", name).c_str(), ImGuiDataType_S32, value, least,
                                most, "%d", flags);
    value_beside(fmt::format("{}", value));
    return touched;
}

void settings(scene::Isolation& isolation, const scene::Isolation& own) {
    const scene::Method method = isolation.method;
    if (scene::takes_steps(method)) magnitude("step", isolation.step, own.step);
    if (method == scene::Method::amp_sign || method == scene::Method::amp_taylor) {
        magnitude("near", isolation.near, own.near);
        magnitude("far", isolation.far, own.far);
        magnitude("horizon", isolation.horizon, own.horizon);
    }
    if (scene::takes_steps(method)) integer("bisections", isolation.bisections, 0, 32);
    if (method == scene::Method::hermite) {
        row("safety");
        slider("##safety", ImGuiDataType_Double, isolation.safety, 1.0, 1024.0, "%.3g",
               ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
        value_beside(fmt::format("{:.3g}", isolation.safety));
        isolation.safety = std::max(1.0, isolation.safety);
    }
    integer("limit", isolation.limit, 1, 100'000, true);
}

// What a slider does: it is the value of a parameter, or multiplies the values of an array's field
// for all `elements`.
std::string slider_tip(const Slider& of, std::optional<int> elements) {
    std::string tip;
    if (elements) {
        const std::string field = of.name.substr(of.name.find('.') + 1);
        tip = fmt::format("multiplies {} of all {} elements\n", field, *elements);
    }
    return tip + (of.overridden ? "held; Ctrl + click to type"
                  : of.moves    ? "moves; a touch holds it, Ctrl + click to type"
                                : "Ctrl + click to type");
}

bool parameter_slider(const Slider& of, Overrides& overrides, std::map<std::string, double>& held,
                      std::optional<int> elements = std::nullopt) {
    const float button = of.overridden ? ImGui::GetFrameHeight() + 4 : 0;
    row(of.name.substr(of.name.find('.') + 1).c_str());
    double value = of.value;
    ImGui::PushID(of.name.c_str());
    const bool touched = slider("##value", ImGuiDataType_Double, value, of.least, of.most, "%.4g",
                                ImGuiSliderFlags_NoRoundToFormat, button);
    record_widget_rect("slider " + of.name);
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
        ImGui::SetTooltip("%s", slider_tip(of, elements).c_str());
    value_beside(fmt::format("{}{:.4g}", elements ? "x " : "", value), button);
    if (touched && std::isfinite(value)) held[of.name] = value;
    if (of.overridden) {
        ImGui::SameLine(0, 4);
        if (ImGui::Button("x", {ImGui::GetFrameHeight(), 0})) {
            overrides.values.erase(of.name);
            overrides.factors.erase(of.name);
        }
        record_widget_rect("give back " + of.name);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("give it back to the scene");
    }
    ImGui::PopID();
    return touched;
}

// "5120 rays right"
std::string audit_text(const audit::Findings& found) {
    if (found.wrong > 0) return fmt::format("{} of {} rays wrong", found.wrong, found.rays);
    return found.rays > 0 ? fmt::format("{} rays right", found.rays) : "no ray could be told";
}

void line(const char* name, const std::string& text) {
    row(name);
    ImGui::TextUnformatted(text.c_str());
}

void audit_lines(const audit::Findings& found) {
    line("audit", audit_text(found));
    if (found.rays > 0 && found.wrong == 0) {
        line("95 % sure", fmt::format("at most {:.0f} in a million wrong",
                                      std::ceil(1e6 * audit::most_wrong(found.rays))));
    }
    ImGui::PushStyleColor(ImGuiCol_Text, error_color());
    for (const audit::WrongPixel& pixel : found.examples) {
        line(fmt::format("{}, {}", pixel.column, pixel.row).c_str(),
             std::string(roots::words(pixel.fault)));
    }
    ImGui::PopStyleColor();
}

} // namespace

bool heading(const char* title) {
    ImGui::Spacing();
    return ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
}

void row(const char* name, float less) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    ImGui::TextUnformatted(name);
    ImGui::PopStyleColor();
    ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + name_width());
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - less);
}

std::optional<Command> title_section(const std::string& title) {
    std::optional<Command> wish;
    const float gap = 4, help = 1.6f * ImGui::GetFontSize(), gallery = 5 * ImGui::GetFontSize();
    ImGui::AlignTextToFramePadding();
    const float room = ImGui::GetContentRegionAvail().x - help - gallery - 3 * gap;
    ImGui::PushClipRect(ImGui::GetCursorScreenPos(),
                        {ImGui::GetCursorScreenPos().x + room,
                         ImGui::GetCursorScreenPos().y + ImGui::GetFrameHeight()},
                        true);
    ImGui::TextUnformatted(title.c_str());
    ImGui::PopClipRect();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", title.c_str());
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - help - gallery - gap);
    if (ImGui::Button("gallery", {gallery, 0})) wish = Command::open;
    record_widget_rect("gallery");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("other scenes (O)");
    ImGui::SameLine(0, gap);
    if (ImGui::Button("?", {help, 0})) wish = Command::help;
    record_widget_rect("help");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("keys and the mouse (?)");
    return wish;
}

void view_section(Look& look, const std::optional<Shown>& shown) {
    if (!heading("View")) return;
    const float gap = 4;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    for (std::size_t k = 0; k < std::size(view_names); ++k) {
        if (k % 3 != 0) ImGui::SameLine(0, gap);
        const bool chosen = look.view == view_names[k].view;
        if (chosen) {
            ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
        }
        if (ImGui::Button(std::string(view_names[k].name).c_str(), {width, 0})) {
            look.view = view_names[k].view;
        }
        if (chosen) ImGui::PopStyleColor();
    }
    if (look.view == View::difference) {
        row("second");
        method_combo("##second", look.other.method);
        ImGui::Checkbox("right of the line: what differs", &look.map);
    }
    if (!shown || shown->view != look.view) return;
    switch (look.view) {
    case View::normal:
        return normal_legend();
    case View::evaluations:
        return heat_legend(shown->heat_end);
    case View::verdicts:
        for (const VerdictColour& entry : verdict_colours()) {
            const auto k = std::size_t(entry.verdict);
            color_line(entry.colour,
                       fmt::format("{}: {}", render::verdict_names[k],
                                   percent(shown->counts.verdicts[k], shown->counts.rays())));
        }
        return;
    case View::difference:
        if (shown->difference) {
            difference_legend(*shown->difference, shown->counts, shown->other);
        }
        return;
    case View::shaded:
    case View::depth:
        return;
    }
}

std::optional<Command> camera_section(Look& look, const scene::CameraAt& camera) {
    if (!heading("Camera")) return std::nullopt;
    std::optional<Command> wish;
    const float gap = 4;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    const auto button = [&](const char* name, const char* tip, Command command) {
        if (ImGui::Button(name, {width, 0})) wish = command;
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tip);
    };
    ImGui::BeginDisabled(!look.camera);
    button("reset", "the scene's own camera (R)", Command::reset_camera);
    ImGui::EndDisabled();
    ImGui::SameLine(0, gap);
    button("fit", "the bounds fill the picture (F)", Command::fit_camera);
    ImGui::SameLine(0, gap);
    button("copy", "as [camera] of a scene file, to the clipboard", Command::copy_camera);
    const bool parallel = camera.projection == scene::Camera::Projection::orthographic;
    if (!parallel) {
        row("view angle");
        double fov = camera.fov;
        if (slider("##fov", ImGuiDataType_Double, fov, 5.0, 120.0, "%.1f",
                   ImGuiSliderFlags_AlwaysClamp)) {
            look.camera = camera;
            look.camera->fov = fov;
        }
        value_beside(fmt::format("{:.1f}°", fov));
    }
    return wish;
}

namespace {

void parameter_sliders(const std::vector<Slider>& all, const std::vector<ArrayControls>& arrays,
                       Overrides& overrides) {
    for (const Slider& slider : all) {
        if (slider.name.find('.') == std::string::npos)
            parameter_slider(slider, overrides, overrides.values);
    }
    for (const ArrayControls& array : arrays) {
        ImGui::PushID(array.name.c_str());
        row(array.name.c_str());
        ImGui::Text("%d elements", array.count);
        for (const Slider& slider : all) {
            if (slider.name.starts_with(array.name + "."))
                parameter_slider(slider, overrides, overrides.values);
        }
        for (const Slider& slider : array.factors)
            parameter_slider(slider, overrides, overrides.factors, array.count);
        ImGui::PopID();
    }
}

// Draws one surface's sliders; of several, under its name.
void parameters_of(const scene::OneSurface& one, Look& look, const Session& session, double time) {
    Overrides own = of_surface(look.overrides, one);
    const animation::Animation& shown = session.overridden().surfaces[one.index].animation;
    const animation::Values values = shown.at(time);
    ImGui::PushID(int(one.index));
    if (!one.is_alone()) {
        ImGui::Spacing();
        ImGui::TextUnformatted(one.surface.label.c_str());
    }
    parameter_sliders(sliders(session.slider_ranges(one.index), values, own),
                      array_controls(one.surface.animation, values, own), own);
    ImGui::PopID();
    put_surface(look.overrides, one, own);
}

} // namespace

void parameter_section(Look& look, const Session& session, double time) {
    const std::vector<scene::Surface>& surfaces = session.scene().surfaces;
    const bool has_none =
        surfaces.size() == 1 && session.slider_ranges(0).empty() &&
        std::ranges::all_of(surfaces.front().animation.arrays(), &animation::Array::is_of_formula);
    if (has_none || !heading("Parameters")) return;
    const Overrides before = look.overrides;
    for (std::size_t k = 0; k < surfaces.size(); ++k)
        parameters_of({session.scene(), k}, look, session, time);
    if (!before.empty() && ImGui::Button("give all back", {-1, 0})) look.overrides = {};
}

void method_section(Look& look, const scene::Scene& scene) {
    if (!heading("Method")) return;
    method_combo("##method", look.isolation.method);
    settings(look.isolation, scene.surfaces.front().isolation);
    if (ImGui::Button("as the scene says", {-1, 0}))
        look.isolation = scene.surfaces.front().isolation;
    ImGui::Checkbox("smooth edges at rest", &look.smooth);
}

void reading_section(const std::optional<Shown>& shown, glm::ivec2 size,
                     const std::optional<Audited>& audited) {
    if (!heading("Reading") || !shown) return;
    const RayCounts& tally = shown->counts;
    const double rays = double(std::max<std::int64_t>(1, tally.rays()));
    const double seconds = std::max(1e-9, tally.drawing.count());
    if (audited) audit_lines(audited->findings);
    line("drawing", fmt::format("{:.1f} ms", 1e3 * seconds));
    line("evaluations", fmt::format("{:.1f} a ray", double(tally.evaluations) / rays));
    line("rays", fmt::format("{:.2f} million/s", 1e-6 * rays / seconds));
    line("size", fmt::format("{} x {} of {} x {}", shown->raster.width, shown->raster.height,
                             size.x, size.y));
    line("samples", fmt::format("{} of {}", shown->samples, shown->asked));
    for (std::size_t k = 0; k < tally.verdicts.size(); ++k) {
        if (tally.verdicts[k] == 0) continue;
        line(render::verdict_names[k], percent(tally.verdicts[k], tally.rays()));
    }
}

void reading_line(const std::optional<Shown>& shown, const std::optional<Audited>& audited) {
    if (!shown) return;
    const RayCounts& tally = shown->counts;
    const double rays = double(std::max<std::int64_t>(1, tally.rays()));
    const std::string drawn = fmt::format(
        "{} x {}   {:.1f} ms   {:.1f} evaluations a ray", shown->raster.width, shown->raster.height,
        1e3 * tally.drawing.count(), double(tally.evaluations) / rays);
    const std::string found = audited ? audit_text(audited->findings) : drawn;
    ImGui::SameLine();
    // Where there is no room for both texts, only what was found is shown.
    for (const std::string& text : {audited ? drawn + "   " + found : drawn, found}) {
        const float begin =
            ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(text.c_str()).x;
        if (ImGui::GetCursorPosX() > begin) continue;
        ImGui::SetCursorPosX(begin);
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", text.c_str());
        return;
    }
    ImGui::NewLine();
}

} // namespace isomotion::player
