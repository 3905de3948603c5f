// Renders frames to files by `isomotion render`, in a process of its own. It runs the same code,
// and neither a long draw nor a crash affects the window.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/child_process.h"
#include "scene/reading/load.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::player {

struct RenderOrder {
    std::filesystem::path scene;
    std::vector<scene::Override> overrides;
    std::string output; // out/name.####.png
    int first = 1, last = 1;
    bool poster = false; // renders only the one frame that represents the scene
    int width = 0, height = 0;
    std::string movie; // empty: no movie
    scene::Reach reach = scene::Reach::own_folder;
};

class RenderProcess {
public:
    // Throws std::system_error if no process can be started, base::InputError for an output that
    // doesn't name files.
    explicit RenderProcess(RenderOrder order);

    bool ended() { return process_.ended(); }
    // The number of frames written, counted by their files from the first on.
    int done();
    int frames() const { return order_.last - order_.first + 1; }
    // Frames that are complete stay.
    void cancel();
    // Waits up to `patience` for its end, since it may have files to put in order.
    void cancel(std::chrono::milliseconds patience);

    // Call it once the process has ended. The reason why not everything was written; otherwise
    // empty.
    std::string error() const;
    const RenderOrder& order() const { return order_; }

private:
    RenderOrder order_;
    sequence::SequenceName name_;
    int written_ = 0;
    std::filesystem::file_time_type begin_;
    bool cancelled_ = false;
    base::ChildProcess process_;
};

// The arguments after `isomotion`.
std::vector<std::string> render_words(const RenderOrder& order);

} // namespace isomotion::player
