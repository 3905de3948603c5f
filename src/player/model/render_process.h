// Renders frames into files by `isomotion render`, in a process of its own: the same code, and
// neither a long draw nor a crash touches the window.
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
    bool poster = false; // the one frame that stands for the scene, instead
    int width = 0, height = 0;
    std::string movie; // empty: none
    scene::Reach reach = scene::Reach::own_folder;
};

class RenderProcess {
public:
    // Throws std::system_error if no process can be started, base::InputError for an output that
    // names no files.
    explicit RenderProcess(RenderOrder order);

    bool ended() { return process_.ended(); }
    // How many frames are written, counted by their files from the first on.
    int done();
    int frames() const { return order_.last - order_.first + 1; }
    // Frames that are whole stay.
    void cancel();
    // Waits so long for its end, since it may have files to put in order.
    void cancel(std::chrono::milliseconds patience);

    // Call once it has ended. Why not all was written; else empty.
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

// The words after `isomotion`.
std::vector<std::string> render_words(const RenderOrder& order);

} // namespace isomotion::player
