// A scene in the hand: what a person changed of it, and what it shows at a frame.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "player/controls.h"
#include "player/marks.h"
#include "player/playback.h"
#include "player/views.h"
#include "scene/scene.h"
#include "scene/scene_at.h"

namespace isomotion::player {

// What is looked at: the scene's time is Playback's.
struct Look {
    Released released;
    std::optional<scene::CameraAt> camera; // moved by hand; none: the scene's own
    scene::Isolation isolation;
    scene::Isolation other; // the method that View::difference holds beside it
    View view = View::shaded;
    bool map = true;    // of View::difference: what sets the methods apart, or the second's picture
    bool smooth = true; // edges, at rest

    bool operator==(const Look&) const = default;
};

class Session {
public:
    // A scene as its file has it, paused at its first frame.
    explicit Session(scene::Scene scene);

    // The same scene from a file that has changed: time, camera, view and what is released stay;
    // settings of the method stay where they were changed by hand.
    void reload(scene::Scene scene, double now);

    const scene::Scene& scene() const { return *scene_; }
    std::shared_ptr<const scene::Scene> shared_scene() const { return scene_; }

    Playback playback;

    const Look& look() const { return look_; }
    // The one way to change it; counts revisions.
    void set(const Look& look);
    std::uint64_t revision() const { return revision_; }

    // The scene with what is released and the camera that is held.
    const scene::Scene& moved() const { return moved_; }
    // Of the picture: a camera that stands nowhere stands so that the bounds fill it.
    void set_size(glm::ivec2 size);
    // Throws scene::SceneError where a value leaves its range.
    scene::SceneAt at(std::int64_t frame, double part = 0) const;

    const std::vector<Span>& spans() const { return spans_; }
    const std::vector<Mark>& key_marks() const { return key_marks_; }

    // That a picture at rest is the mean of.
    int samples() const;

private:
    void study();
    void move();

    std::shared_ptr<const scene::Scene> scene_;
    Look look_;
    scene::Scene moved_;
    glm::ivec2 size_;
    std::uint64_t revision_ = 1;
    std::vector<Span> spans_;
    std::vector<Mark> key_marks_;
};

} // namespace isomotion::player
