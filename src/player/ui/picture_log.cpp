#include "player/ui/picture_log.h"

#include <cerrno>

#include <nlohmann/json.hpp>

#include "base/file.h"

namespace isomotion::player {

PictureLog::PictureLog(const std::filesystem::path& file)
    : file_(file.empty() ? nullptr : std::fopen(file.c_str(), "we"), std::fclose) {
    if (!file.empty() && !file_) throw base::FileError(file, "cannot be written", errno);
    if (file_) start_recording_widget_rects();
}

void PictureLog::write(const std::string& line) {
    std::fprintf(file_.get(), "%s\n", line.c_str());
    std::fflush(file_.get());
}

void PictureLog::add(const WidgetRects& rects) {
    if (!file_ || rects == last_) return;
    last_ = rects;
    write(nlohmann::ordered_json{{"seconds", seconds(Clock::now())}, {"widgets", rects}}.dump());
}

double PictureLog::seconds(Clock::time_point at) const {
    return std::chrono::duration<double>(at - begin_).count();
}

void PictureLog::add(const Shown& shown, glm::ivec2 corner, glm::ivec2 size, bool at_rest) {
    if (!file_) return;
    const nlohmann::ordered_json line{
        {"seconds", seconds(Clock::now())},
        {"asked", seconds(shown.asked_at)},
        {"frame", shown.frame},
        {"view", name(shown.view)},
        {"scale", shown.scale},
        {"samples", shown.samples},
        {"at_rest", at_rest},
        {"corner", {corner.x, corner.y}},
        {"size", {size.x, size.y}},
        {"drawn", {shown.raster.width, shown.raster.height}},
        {"milliseconds", 1e3 * shown.took.count()},
        {"compiled", shown.compiled},
        {"evaluations", shown.counts.evaluations},
        {"verdicts", shown.counts.verdicts},
    };
    write(line.dump());
}

void PictureLog::add(const Audited& audited) {
    if (!file_) return;
    const audit::Findings& found = audited.findings;
    nlohmann::ordered_json pixels = nlohmann::ordered_json::array();
    for (const audit::WrongPixel& pixel : found.examples)
        pixels.push_back({pixel.column, pixel.row});
    const nlohmann::ordered_json line{{"seconds", seconds(Clock::now())},
                                      {"audited", found.rays},
                                      {"wrong", found.wrong},
                                      {"undecided", found.undecided},
                                      {"wrong_pixels", pixels}};
    write(line.dump());
}

void PictureLog::add_failure(const std::string& text) {
    if (!file_) return;
    const nlohmann::ordered_json line{{"seconds", seconds(Clock::now())}, {"error", text}};
    write(line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

} // namespace isomotion::player
