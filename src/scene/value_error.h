// A value out of its range at a time.
#pragma once

#include <string>

#include <fmt/format.h>

#include "scene/error.h"

namespace isomotion::scene {

// `name` is the value's name as a track or an array's field: "camera.fov", "blobs.cx[2]".
class ValueError : public SceneError {
public:
    // `where`: its place and key, "ring.toml:9: camera.fov".
    ValueError(const std::string& where, std::string name, double time, const std::string& why)
        : SceneError(fmt::format("{} at t = {}: {}", where, time, why))
        , name_(std::move(name))
        , time_(time)
        , why_(why) {}
    const std::string& name() const { return name_; }
    double time() const { return time_; }
    const std::string& why() const { return why_; }

private:
    std::string name_;
    double time_;
    std::string why_;
};

} // namespace isomotion::scene
