// Scenes of Surfer and jSurf: .jsurf files, lists of key=value.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace isomotion::scene {

// The scene in TOML, each key in the line of the property that it comes from, so that mistakes
// found in it later are told with the line of the .jsurf file. Surface, parameters, camera, colours
// and lights are read, other properties are not. Throws SceneError: "file:line: key: what is
// wrong".
//
// Surfer scales the surface into a ball of radius 1 that clips it, and turns it; here the bounds
// are as large as the ball is in the surface's own coordinates, and the camera and the lights turn.
// Surfer adds up light in sRGB. Colours are converted, and each light alone gives, straight on,
// what it gives there; where several lights fall, sums differ.
std::string surfer_as_toml(std::string_view text, const std::filesystem::path& file);

} // namespace isomotion::scene
