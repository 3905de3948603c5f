#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/confines.h"

namespace isomotion::image {

/// Light from every direction: a picture of the whole sphere, with longitude across and latitude
/// down.
struct EnvironmentMap {
    int width = 0;
    int height = 0;            ///< half the width
    std::vector<float> texels; ///< linear R, G, B and 1; row by row, the top row first; all finite
    int mended = 0;            ///< texels that were invalid, see read_environment()
};

inline constexpr int widest_environment = 8192;

/// Reads a map from an EXR, HDR, TIFF, PNG or JPEG, identified by its first bytes. Colour in sRGB
/// or with a gamma becomes linear. A file of integers that names no colour space, as most TIFF,
/// counts as sRGB. Gray is expanded to three channels, coverage is composited over black, and other
/// channels are ignored.
///
/// Invalid texels are repaired so that they don't spoil filtering: NaN and values below 0 become 0,
/// infinity becomes the largest finite value of the map, or of half if that is 0, and nothing stays
/// above 10^6. `mended` counts such texels.
///
/// Throws a FileError if the file cannot be read. Throws an ImageError if it is not a complete
/// picture, has no colour, is wider than `widest_environment` (checked before its pixels are read)
/// or is not twice as wide as high: any other shape has another projection, and would show a wrong
/// world.
EnvironmentMap read_environment(const std::filesystem::path& file);

/// Receives a map as it is read: its size, then its rows from the top, some at a time. The widest
/// map has half a gigabyte of texels, which thus need not be in memory twice.
struct EnvironmentSink {
    std::function<void(int width, int height)> begin;
    std::function<void(int first, std::span<const float> texels)> rows; ///< as in EnvironmentMap
};

/// Returns the number of repaired texels. `stated_at` is where a user named the file, for messages:
/// `scene.toml:4: environment.map`. Throws as above, and an InputError if the opened file lies
/// outside its confines. Decodes files of floats twice, since the largest value must be known
/// before the first row.
int read_environment(const std::filesystem::path& file, const EnvironmentSink& sink,
                     const base::Confines& within, std::string_view stated_at = {});

/// The message on a map with repaired texels: `environment FILE: 12 texels were ...`.
std::string mending(const std::filesystem::path& file, int mended);

} // namespace isomotion::image
