// The parts of the side panel: each shows and changes its part of the look.
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

// A part's heading; false if it is folded.
bool heading(const char* title);
// A line's name on the left; the widget that follows takes the rest, less `less`.
void row(const char* name, float less = 0);

// The scene's title, and the buttons of the gallery and of the help. Returns the command of one
// that was clicked.
std::optional<Command> title_section(const std::string& title);

void view_section(Look& look, const scene::Scene& scene, const std::optional<Shown>& shown);

// Returns the command of a button that was clicked.
std::optional<Command> camera_section(Look& look, const scene::CameraAt& camera);

void parameter_section(Look& look, const Session& session, const animation::Values& values);

void method_section(Look& look, const scene::Scene& scene);

// What the last picture took: in full, and as one right-aligned line.
// Beside it what an audit found of it, once it rests.
void reading_section(const std::optional<Shown>& shown, glm::ivec2 size,
                     const std::optional<Audited>& audited);
void reading_line(const std::optional<Shown>& shown, const std::optional<Audited>& audited);

// Saves frames as files.
class ExportSection {
public:
    ExportSection() = default;
    ~ExportSection(); // ends what runs, in good order if that takes no longer than a second
    ExportSection(const ExportSection&) = delete;
    ExportSection& operator=(const ExportSection&) = delete;

    // `frame` is the one shown, in a picture of `size`.
    void show(const LiveScene& scene, std::int64_t frame, glm::ivec2 size);
    // Saves the shaded picture as it is shown at rest, whatever the view.
    void save_picture(const LiveScene& scene, std::int64_t frame, glm::ivec2 size);
    // Whether files are being written.
    bool running() const { return process_.has_value(); }
    // Looks after the process. Returns, once it is known, why not all was written.
    std::optional<std::string> attend();

private:
    void start(const LiveScene& live, int first, int last, glm::ivec2 size, int samples);
    std::string stem(const scene::Scene& scene) const;

    std::optional<RenderProcess> process_;
    std::filesystem::path folder_ = "out";
    std::array<int, 2> range_{0, 0};                         // 0: not chosen yet
    std::filesystem::path range_of_;                         // scene
    bool as_shown_ = false, smooth_ = false, movie_ = false; // of many frames
    std::string told_;
    bool failed_ = false;
};

} // namespace isomotion::player
