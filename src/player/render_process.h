// Frames rendered into files by `isomotion render` itself, in a process of its own: the same code,
// and neither a long draw nor a crash in it touches the window.
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
    // Of the frames, how many are written: from the first on, by their files.
    int done();
    int frames() const { return order_.last - order_.first + 1; }
    // Whole frames stay.
    void cancel();
    // Cancels it and waits for its end so long, for one that has files to put in order.
    void cancel(std::chrono::milliseconds patience);

    // Once it has ended: empty where all was written, else why not.
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

// A scene's name as the beginning of a frame's: what would be a place for the frame's number is
// not.
std::string stem_of_frames(std::string name);

// The words after `isomotion`.
std::vector<std::string> render_words(const RenderOrder& order);

} // namespace isomotion::player
