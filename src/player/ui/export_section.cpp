#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "base/child_process.h"
#include "player/model/render_settings.h"
#include "player/ui/sections.h"
#include "player/ui/theme.h"
#include "player/ui/widget_rects.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::player {

std::string ExportSection::stem(const scene::Scene& scene) const {
    return (folder_ / sequence::stem_of_frames(scene.file.stem().string())).string();
}

ExportSection::~ExportSection() {
    if (process_) process_->cancel(std::chrono::seconds(1));
}

void ExportSection::start(const LiveScene& live, int first, int last, glm::ivec2 size,
                          int samples) {
    const scene::Scene& scene = live.session.scene();
    RenderOrder order;
    order.scene = scene::reload_argument(scene);
    order.output = stem(scene) + ".####.png";
    order.first = first;
    order.last = last;
    order.width = size.x;
    order.height = size.y;
    order.reach = live.reach();
    if (movie_ && last > first) order.movie = stem(scene) + ".mp4";
    told_.clear();
    failed_ = false;
    try {
        order.overrides = live.overrides();
        const auto more = render_settings(live.session);
        order.overrides.insert(order.overrides.end(), more.begin(), more.end());
        order.overrides.push_back(fmt::format("output.samples={}", samples));
        process_.emplace(std::move(order));
    } catch (const std::exception& error) {
        told_ = error.what();
        failed_ = true;
    }
}

void ExportSection::save_picture(const LiveScene& scene, std::int64_t frame, glm::ivec2 size) {
    if (process_) return;
    start(scene, int(frame), int(frame), size, scene.session.samples());
}

std::optional<std::string> ExportSection::attend() {
    if (!process_ || !process_->ended()) return std::nullopt;
    const RenderOrder& order = process_->order();
    told_ = process_->error();
    failed_ = !told_.empty();
    if (!failed_) {
        const auto name = sequence::SequenceName::parse(order.output);
        told_ = order.first == order.last ? name.path(order.first).string() : order.output;
        if (!order.movie.empty()) told_ += "\n" + order.movie;
    }
    process_.reset();
    return failed_ ? std::optional(told_) : std::nullopt;
}

void ExportSection::show(const LiveScene& live, std::int64_t frame, glm::ivec2 size) {
    if (!heading("Export")) return;
    const scene::Scene& scene = live.session.scene();
    const int last = scene.timeline.frames;
    if (scene.file != range_of_ || range_[0] < 1 || range_[1] > last) range_ = {1, last};
    range_of_ = scene.file;
    const scene::Output& output = scene.output;
    const std::string own = fmt::format("{} x {}", output.width, output.height);
    const std::string here = fmt::format("{} x {}, as shown", size.x, size.y);
    row("size");
    if (ImGui::BeginCombo("##size", (as_shown_ ? here : own).c_str())) {
        if (ImGui::Selectable(own.c_str(), !as_shown_)) as_shown_ = false;
        if (ImGui::Selectable(here.c_str(), as_shown_)) as_shown_ = true;
        ImGui::EndCombo();
    }
    row("frames");
    if (ImGui::DragIntRange2("##frames", range_.data(), range_.data() + 1, 0.3f, 1, last, "from %d",
                             "to %d", ImGuiSliderFlags_AlwaysClamp)) {
        range_[1] = std::max(range_[0], range_[1]);
    }
    ImGui::Checkbox("16 samples a pixel", &smooth_);
    static const bool has_ffmpeg = base::find_program("ffmpeg").has_value();
    if (has_ffmpeg) ImGui::Checkbox("join them in a movie", &movie_);
    if (process_) {
        const int done = process_->done(), all = process_->frames();
        ImGui::ProgressBar(float(done) / float(all), {-1, 0},
                           fmt::format("{} of {}", done, all).c_str());
        if (ImGui::Button("cancel", {-1, 0})) process_->cancel();
        return;
    }
    const float gap = 4;
    const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
    if (ImGui::Button("save picture", {width, 0})) save_picture(live, frame, size);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("frame %lld, shaded, in the size shown, to %s.####.png (F12)",
                          static_cast<long long>(frame), stem(scene).c_str());
    }
    ImGui::SameLine(0, gap);
    if (ImGui::Button("save frames", {width, 0})) {
        const glm::ivec2 wanted = as_shown_ ? size : glm::ivec2(output.width, output.height);
        start(live, range_[0], range_[1], wanted,
              smooth_ ? std::max(16, output.samples) : output.samples);
    }
    record_widget_rect("save frames");
    if (told_.empty()) return;
    ImGui::PushTextWrapPos(0);
    if (failed_) {
        ImGui::PushStyleColor(ImGuiCol_Text, error_color());
        ImGui::TextUnformatted(told_.c_str());
        ImGui::PopStyleColor();
    } else {
        ImGui::TextDisabled("written: %s", told_.c_str());
    }
    ImGui::PopTextWrapPos();
}

} // namespace isomotion::player
