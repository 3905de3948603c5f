// An open scene: the changes that a person made to it, and what it shows at a frame.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "player/model/controls.h"
#include "player/model/playback.h"
#include "player/model/timeline_markers.h"
#include "player/model/view.h"
#include "scene/scene.h"
#include "scene/scene_at.h"

namespace isomotion::player {

// The state of the display, except the time, which is Playback's.
struct Look {
    Overrides overrides;
    std::optional<scene::CameraAt> camera; // the camera override
    scene::Isolation isolation;
    scene::Isolation other; // the method that View::difference compares with
    View view = View::shaded;
    bool map = true;    // View::difference shows where the methods differ, instead of the second
                        // method's picture
    bool smooth = true; // anti-aliased edges, at rest

    bool operator==(const Look&) const = default;
};

class Session {
public:
    // Starts with the file's state, paused at its first frame.
    explicit Session(scene::Scene scene);

    // Replaces the scene after its file has changed. Time, view and overrides stay; so do settings
    // of the method that a person changed.
    void reload(scene::Scene scene, double now);

    const scene::Scene& scene() const { return *scene_; }
    std::shared_ptr<const scene::Scene> shared_scene() const { return scene_; }

    Playback playback;

    const Look& look() const { return look_; }
    // The only way to change the look; increments the revision.
    void set(const Look& look);
    std::uint64_t revision() const { return revision_; }

    // The scene with all overrides.
    const scene::Scene& overridden() const { return overridden_; }
    // The picture's size. It matters for a camera without a position, which moves to where the
    // bounds fill the picture.
    void set_size(glm::ivec2 size);
    // Throws scene::SceneError if a value leaves its range.
    scene::SceneAt at(std::int64_t frame, double part = 0) const;

    // The ranges of one surface.
    const std::vector<SliderRange>& slider_ranges(std::size_t surface) const {
        return slider_ranges_[surface];
    }
    const std::vector<TimelineMarker>& key_markers() const { return key_markers_; }

    // The number of pictures averaged at rest.
    int samples() const;

private:
    void study();
    void hold();
    void move();

    std::shared_ptr<const scene::Scene> scene_;
    Look look_;
    scene::Scene held_; // with the overrides but the camera's
    scene::Scene overridden_;
    glm::ivec2 size_;
    std::uint64_t revision_ = 1;
    std::vector<std::vector<SliderRange>> slider_ranges_; // for each surface
    std::vector<TimelineMarker> key_markers_;
};

} // namespace isomotion::player
