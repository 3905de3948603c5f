#include "player/ui/gallery.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "base/file.h"
#include "base/fingerprint.h"
#include "image/decode.h"
#include "player/draw/views.h"
#include "player/model/file_watch.h"
#include "player/model/memory.h"
#include "player/ui/theme.h"
#include "player/ui/widget_rects.h"
#include "scene/data_folder.h"
#include "scene/error.h"
#include "scene/reading/load.h"

namespace isomotion::player {
namespace fs = std::filesystem;
namespace {

constexpr int picture_side = 192;

void add_file(base::Fingerprint& print, const fs::path& file) {
    try {
        print.add(file.string());
        print.add(base::read_whole(file));
    } catch (const base::FileError&) { // gone meanwhile
    }
}

// A fingerprint of everything but the scene that decides a gallery picture.
std::string foundation() {
    base::Fingerprint print;
    for (const fs::path& file : shader_files()) add_file(print, file);
    for (const auto& name : scene::surface_names()) add_file(print, scene::surface_file(name));
    return print.text();
}

std::string in_lower_case(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

} // namespace

void Gallery::add(const std::string& scene, const fs::path& file, const std::string& ground) {
    Entry entry;
    entry.scene = scene;
    try {
        entry.title = scene::title(file);
    } catch (const scene::SceneError&) {
        entry.title = file.stem().string();
    }
    if (const fs::path folder = cache_folder(); !folder.empty()) {
        base::Fingerprint print;
        print.add(ground);
        add_file(print, file);
        entry.picture = folder / "thumbnails" / (print.text() + ".png");
    }
    entries_.push_back(std::move(entry));
}

void Gallery::open(const std::vector<fs::path>& opened) {
    open_ = true;
    entries_.clear();
    process_.reset();
    const std::string ground = foundation();
    const fs::path installed = scene::data_folder() / "animations";
    for (const fs::path& file : opened) {
        if (file.parent_path() != installed) add(file.string(), file, ground);
    }
    opened_ = entries_.size();
    for (const auto& name : scene::animation_names())
        add(name, scene::animation_file(name), ground);
    sheet_.emplace(entries_.size() - opened_);
}

void Gallery::close() {
    open_ = false;
    process_.reset();
    entries_.clear();
    sheet_.reset();
}

bool Gallery::take_picture(Entry& entry) {
    std::error_code error;
    if (!fs::is_regular_file(entry.picture, error)) return false;
    try {
        const image::Frame frame = image::decode(entry.picture);
        entry.texture.emplace();
        entry.texture->update(frame.width, frame.height, shaded(frame).rgba,
                              gpu::ScreenTexture::Enlarged::smooth);
        return true;
    } catch (const std::runtime_error&) { // broken: it is rendered again
        entry.texture.reset();
        return false;
    }
}

bool Gallery::attend() {
    if (!open_) return false;
    bool news = false;
    if (process_) {
        if (!process_->ended()) return false;
        Entry& entry = entries_[rendered_];
        entry.failed = !take_picture(entry);
        process_.reset();
        news = true;
    }
    for (std::size_t k = 0; k < entries_.size(); ++k) {
        Entry& entry = entries_[k];
        if (entry.texture || entry.failed || entry.picture.empty()) continue;
        if (take_picture(entry)) return true; // the next at the next frame: none takes long
        RenderOrder order;
        order.scene = entry.scene;
        order.output = entry.picture.string();
        order.poster = true;
        order.width = order.height = picture_side;
        order.overrides = {"output.samples=4"};
        try {
            process_.emplace(std::move(order));
            rendered_ = k;
        } catch (const std::exception&) {
            entry.failed = true;
        }
        return true;
    }
    return news;
}

// The entry's own picture, or that of the sheet, or an empty place.
void Gallery::show_picture(std::size_t at, const std::array<float, 2>& from, float side) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 begin{from[0], from[1]}, end{from[0] + side, from[1] + side};
    const float rounding = 5;
    const auto show = [&](unsigned texture, ImVec2 upper_left, ImVec2 lower_right) {
        list.AddImageRounded(reinterpret_cast<ImTextureID>(std::uintptr_t(texture)), begin, end,
                             upper_left, lower_right, IM_COL32_WHITE, rounding);
    };
    const auto& own = entries_[at].texture;
    const auto of_sheet = at < opened_ || !sheet_ ? std::nullopt : sheet_->part(at - opened_);
    if (own)
        show(own->id(), {0, 0}, {1, 1});
    else if (of_sheet)
        show(of_sheet->texture, {of_sheet->begin[0], of_sheet->begin[1]},
             {of_sheet->end[0], of_sheet->end[1]});
    else
        list.AddRectFilled(begin, end, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
    if (ImGui::IsItemHovered()) list.AddRect(begin, end, accent_color(), rounding, 0, 2);
}

bool Gallery::show_entry(std::size_t number, float side) {
    const Entry& entry = entries_[number];
    ImGui::BeginGroup();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(&entry);
    const bool chosen = ImGui::InvisibleButton("open", {side, side});
    ImGui::PopID();
    record_widget_rect("scene " + entry.scene);
    show_picture(number, {at.x, at.y}, side);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", entry.scene.c_str());
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + side);
    ImGui::TextUnformatted(entry.title.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    return chosen;
}

std::optional<std::string> Gallery::show() {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Gallery");
    ImGui::SameLine(0, 2 * ImGui::GetFontSize());
    ImGui::SetNextItemWidth(14 * ImGui::GetFontSize());
    ImGui::InputTextWithHint("##filter", "filter by title", filter_.data(), filter_.size());
    ImGui::SameLine(0, 2 * ImGui::GetFontSize());
    ImGui::TextDisabled("or drop a scene file on the window");
    ImGui::Spacing();

    std::optional<std::string> chosen;
    ImGui::BeginChild("pictures");
    const std::string wanted = in_lower_case(filter_.data());
    const float gap = ImGui::GetFontSize();
    const float width = ImGui::GetContentRegionAvail().x;
    const int columns = std::max(1, int((width + gap) / (11 * ImGui::GetFontSize() + gap)));
    const float side = std::floor((width - float(columns - 1) * gap) / float(columns));
    int column = 0;
    const auto heading = [&](const char* text) {
        if (column != 0) ImGui::NewLine();
        column = 0;
        ImGui::TextDisabled("%s", text);
    };
    if (opened_ > 0) heading("opened before");
    for (std::size_t k = 0; k < entries_.size(); ++k) {
        if (k == opened_ && opened_ > 0) heading("comes with isomotion");
        const Entry& entry = entries_[k];
        if (in_lower_case(entry.title + entry.scene).find(wanted) == std::string::npos) continue;
        if (column > 0) ImGui::SameLine(0, gap);
        column = (column + 1) % columns;
        if (show_entry(k, side)) chosen = entry.scene;
        if (column == 0) ImGui::Dummy({0, 0.4f * gap});
    }
    ImGui::EndChild();
    return chosen;
}

} // namespace isomotion::player
