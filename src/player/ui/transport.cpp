#include "player/ui/transport.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "player/ui/icons.h"
#include "player/ui/theme.h"
#include "player/ui/widget_rects.h"

namespace isomotion::player {
namespace {

std::string speed_name(int doublings) {
    return doublings < 0 ? fmt::format("1/{}x", 1 << -doublings)
                         : fmt::format("{}x", 1 << doublings);
}

unsigned color_of(TimelineMarker::Kind kind) {
    switch (kind) {
    case TimelineMarker::Kind::key:
        return faint_color();
    case TimelineMarker::Kind::event:
        return ImGui::GetColorU32(ImVec4(0.95f, 0.72f, 0.3f, 0.9f));
    case TimelineMarker::Kind::unresolved:
        break;
    }
    return error_color();
}

float scrubber_height() { return 1.15f * ImGui::GetFrameHeight(); }

} // namespace

float Transport::height() {
    const ImGuiStyle& style = ImGui::GetStyle();
    return 2 * style.WindowPadding.y + scrubber_height() + style.ItemSpacing.y +
           ImGui::GetFrameHeight();
}

Playback Transport::show(const Playback& playback, const animation::Timeline& timeline,
                         const std::vector<TimelineMarker>& markers, double now) {
    Playback next = scrubber(playback, markers, now);
    next = buttons(next, now);
    ImGui::SameLine(0, 2 * ImGui::GetStyle().WindowPadding.x);
    next = speed(next, now);
    ImGui::SameLine(0, 2 * ImGui::GetStyle().WindowPadding.x);
    return place(next, timeline, now);
}

Playback Transport::buttons(Playback playback, double now) {
    const bool playing = playback.playing;
    if (icon_button("first", Icon::first, false, "to the first frame (Home)")) {
        playback = scrubbed(playback, playback.first, now);
    }
    ImGui::SameLine();
    if (icon_button("back", Icon::back, false, "a frame back (Left)")) {
        playback = stepped(playback, -1, now);
    }
    ImGui::SameLine();
    if (icon_button("play", playing ? Icon::pause : Icon::play, playing,
                    playing ? "pause (Space)" : "play (Space)")) {
        playback = toggled(playback, now);
    }
    ImGui::SameLine();
    if (icon_button("forward", Icon::forward, false, "a frame on (Right)")) {
        playback = stepped(playback, 1, now);
    }
    ImGui::SameLine();
    if (icon_button("last", Icon::last, false, "to the last frame (End)")) {
        playback = scrubbed(playback, playback.last, now);
    }
    ImGui::SameLine();
    if (icon_button("loop", Icon::loop, playback.loop,
                    playback.loop ? "play once (L)" : "play over and over (L)")) {
        playback = with_loop(playback, !playback.loop, now);
    }
    return playback;
}

Playback Transport::speed(Playback playback, double now) {
    ImGui::SetNextItemWidth(4.2f * ImGui::GetFontSize());
    if (ImGui::BeginCombo("##speed", speed_name(playback.doublings).c_str(),
                          ImGuiComboFlags_HeightLarge)) {
        for (int k = most_doublings; k >= least_doublings; --k) {
            if (ImGui::Selectable(speed_name(k).c_str(), k == playback.doublings)) {
                playback = with_speed(playback, k, now);
            }
        }
        ImGui::EndCombo();
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("speed ([ and ])");
    return playback;
}

Playback Transport::place(Playback playback, const animation::Timeline& timeline, double now) {
    const float number_width = 4.8f * ImGui::GetFontSize();
    const std::int64_t frame = frame_at(playback, now).frame;
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("frame");
    ImGui::SameLine();
    int typed = int(frame);
    ImGui::SetNextItemWidth(number_width);
    if (ImGui::InputInt("##frame", &typed, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue)) {
        playback = scrubbed(playback, typed, now);
    }
    ImGui::SameLine();
    ImGui::TextDisabled("of %lld", static_cast<long long>(playback.last));
    ImGui::SameLine(0, 2 * ImGui::GetStyle().WindowPadding.x);
    ImGui::TextDisabled("t =");
    ImGui::SameLine();
    double time = timeline.time(frame);
    ImGui::SetNextItemWidth(number_width);
    if (ImGui::InputDouble("##time", &time, 0, 0, "%.3f", ImGuiInputTextFlags_EnterReturnsTrue)) {
        playback = jumped_to_time(playback, time, now);
    }
    ImGui::SameLine();
    ImGui::TextDisabled("s at %s frames/s", animation::to_string(timeline.fps).c_str());
    return playback;
}

Playback Transport::scrubber(Playback playback, const std::vector<TimelineMarker>& markers,
                             double now) {
    const float width = ImGui::GetContentRegionAvail().x, height = scrubber_height();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("##timeline", {std::max(width, 1.0f), height});
    record_widget_rect("timeline");
    const bool held = ImGui::IsItemActive();
    const float knob = 0.32f * ImGui::GetFontSize();
    const float left = corner.x + knob, right = corner.x + width - knob;
    const float line = corner.y + 0.62f * height;
    const double frames = double(playback.last - playback.first);
    const auto x_of = [&](double frame) {
        const double u = frames > 0 ? (frame - double(playback.first)) / frames : 0.0;
        return left + float(std::clamp(u, 0.0, 1.0)) * (right - left);
    };
    const auto frame_under = [&](float x) {
        const double u = right > left ? (x - left) / (right - left) : 0.0;
        return playback.first + std::llround(std::clamp(u, 0.0, 1.0) * frames);
    };
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (held) {
        if (!scrubbing_) played_ = playback.playing;
        playback = scrubbed(paused(playback, now), frame_under(mouse.x), now);
    } else if (scrubbing_ && played_) {
        playback = played(playback, now);
    }
    scrubbing_ = held;

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float thickness = std::max(2.0f, 0.2f * ImGui::GetFontSize());
    const float here = x_of(double(frame_at(playback, now).frame));
    list.AddRectFilled({left, line - thickness / 2}, {right, line + thickness / 2},
                       ImGui::GetColorU32(ImGuiCol_FrameBgActive), thickness / 2);
    list.AddRectFilled({left, line - thickness / 2}, {here, line + thickness / 2}, accent_color(),
                       thickness / 2);
    const TimelineMarker* nearest = nullptr;
    for (const TimelineMarker& marker : markers) {
        const float x = x_of(marker.frame);
        const float half = std::max(1.0f, 0.06f * ImGui::GetFontSize());
        const bool is_key = marker.kind == TimelineMarker::Kind::key;
        list.AddRectFilled({x - half, corner.y + (is_key ? 0.22f : 0.02f) * height},
                           {x + half, corner.y + 0.4f * height}, color_of(marker.kind));
        const float reach = std::abs(mouse.x - x);
        if (reach < 4 * half + 2 &&
            (!nearest || reach < std::abs(mouse.x - x_of(nearest->frame)))) {
            nearest = &marker;
        }
    }
    list.AddCircleFilled({here, line}, knob, accent_color(), 20);
    if (ImGui::IsItemHovered() || held) {
        if (nearest && !held) {
            ImGui::SetTooltip("%s", nearest->label.c_str());
        } else {
            ImGui::SetTooltip("%lld", static_cast<long long>(frame_under(mouse.x)));
        }
    }
    return playback;
}

} // namespace isomotion::player
