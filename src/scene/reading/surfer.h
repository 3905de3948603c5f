// Reads scenes of Surfer and jSurf: .jsurf files, lists of key=value.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace isomotion::scene {

// The scene in TOML. Each key is in the line of the property that it comes from, so later mistakes
// in it are reported with the line of the .jsurf file. Reads surface, parameters, camera, colours
// and lights; ignores other properties. Throws SceneError: "file:line: key: what is wrong".
//
// Surfer turns the surface and scales it into a ball of radius 1 that clips it. Here the bounds
// have the ball's size in the surface's own coordinates, and the camera and the lights turn. Surfer
// adds up light in sRGB. Colours are converted so that each light alone, straight on, gives the
// same colour as in Surfer. Where several lights fall, the sums differ.
std::string surfer_as_toml(std::string_view text, const std::filesystem::path& file);

} // namespace isomotion::scene
