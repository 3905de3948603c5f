// A gallery of pictures of the installed animations and of scenes opened before, to choose from.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gpu/screen.h"
#include "player/model/render_process.h"
#include "player/ui/gallery_sheet.h"

namespace isomotion::player {

class Gallery {
public:
    // Lists the installed animations. `opened`: scenes opened before, the newest first.
    void open(const std::vector<std::filesystem::path>& opened);
    void close();
    bool is_open() const { return open_; }

    // Fills Dear ImGui's current window. Returns the scene that was chosen.
    std::optional<std::string> show();

    // Renders missing pictures, one after another, into the user's cache. Returns true if there is
    // something new to show.
    bool attend();
    bool rendering() const { return process_.has_value(); }

private:
    struct Entry {
        std::string scene; // the argument that opens it: a name or a path
        std::string title;
        std::filesystem::path picture; // in the cache; empty if pictures can't be kept
        bool failed = false;
        std::optional<gpu::ScreenTexture> texture;
    };

    bool show_entry(std::size_t at, float side);
    void show_picture(std::size_t at, const std::array<float, 2>& from, float side) const;
    bool take_picture(Entry& entry);
    void add(const std::string& scene, const std::filesystem::path& file,
             const std::string& foundation);

    bool open_ = false;
    std::vector<Entry> entries_;
    std::size_t opened_ = 0;            // number of scenes opened before; they come first
    std::optional<GallerySheet> sheet_; // of the installed animations
    std::optional<RenderProcess> process_;
    std::size_t rendered_ = 0; // the entry being rendered
    std::array<char, 64> filter_{};
};

} // namespace isomotion::player
