// The sections of the side panel. Each shows and changes a part of the look.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "player/draw/draw_thread.h"
#include "player/model/live_scene.h"
#include "player/model/render_process.h"
#include "player/model/session.h"
#include "player/ui/shortcuts.h"

namespace isomotion::player {

// A section's heading; false if it is folded.
bool heading(const char* title);
// A line's name on the left; the next widget takes the remaining width, minus `less`.
void row(const char* name, float less = 0);

// The scene's title, and the buttons of the gallery and of the help. Returns the command of a
// button that was clicked.
std::optional<Command> title_section(const std::string& title);

void view_section(Look& look, const std::optional<Shown>& shown);

// Returns the command of a button that was clicked.
std::optional<Command> camera_section(Look& look, const scene::CameraAt& camera);

void parameter_section(Look& look, const Session& session, double time);

void method_section(Look& look, const scene::Scene& scene);

// The statistics of the last picture, in full and as one right-aligned line, with the findings of
// an audit once the picture is at rest.
void reading_section(const std::optional<Shown>& shown, glm::ivec2 size,
                     const std::optional<Audited>& audited);
void reading_line(const std::optional<Shown>& shown, const std::optional<Audited>& audited);

// Saves frames as files.
class ExportSection {
public:
    ExportSection() = default;
    ~ExportSection(); // ends a running export; lets it finish in order for up to a second
    ExportSection(const ExportSection&) = delete;
    ExportSection& operator=(const ExportSection&) = delete;

    // `frame` is the frame shown, in a picture of `size`.
    void show(const LiveScene& scene, std::int64_t frame, glm::ivec2 size);
    // Saves the shaded picture as it is shown at rest, whatever the view.
    void save_picture(const LiveScene& scene, std::int64_t frame, glm::ivec2 size);
    // Whether files are being written.
    bool running() const { return process_.has_value(); }
    // Checks the process. Returns, once it is known, why not everything was written.
    std::optional<std::string> attend();

private:
    void start(const LiveScene& live, int first, int last, glm::ivec2 size, int samples);
    std::string stem(const scene::Scene& scene) const;

    std::optional<RenderProcess> process_;
    std::filesystem::path folder_ = "out";
    std::array<int, 2> range_{0, 0};                         // 0: not chosen yet
    std::filesystem::path range_of_;                         // scene
    bool as_shown_ = false, smooth_ = false, movie_ = false; // for a range of frames
    std::string told_;
    bool failed_ = false;
};

} // namespace isomotion::player
