// Joins a sequence to a movie.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "image/frame.h"

namespace isomotion::sequence {

// Throws an Error (input) unless the name's extension is one of the three below and its format
// supports that rate, so that this is known before the first picture is rendered.
void check_movie(const std::filesystem::path& movie, image::Rational frames_per_second);

// Throws an Error (device) if there is no ffmpeg.
void expect_ffmpeg();

// The pictures of a movie, each asked for once and in order: as files, or as they are drawn.
struct MoviePictures {
    std::size_t count = 0;
    std::function<image::Frame(std::size_t)> picture;
    std::function<std::string(std::size_t)> name; // for errors
};

// Makes a movie of pictures of one size, in the order given, with the ffmpeg program on PATH:
// `.mp4` (H.264), `.webm` (VP9) or `.gif`. Transparency shows black. Odd sizes are made even, as
// H.264 and VP9 require, by repeating the last column or row. The same pictures give the same bytes
// with the same ffmpeg. The file appears only when it is complete. Returns false if `stop` returned
// true before that.
//
// Throws an Error, with ffmpeg's own words if it fails; what `picture` throws; a FileError if the
// movie cannot be written there; a std::system_error if ffmpeg exists but does not start.
bool write_movie(const std::filesystem::path& movie, const MoviePictures& pictures,
                 image::Rational frames_per_second, const std::function<bool()>& stop = {});

// The same with files. Throws the errors of decode() for a picture that cannot be read, too.
bool write_movie(const std::filesystem::path& movie,
                 std::span<const std::filesystem::path> pictures, image::Rational frames_per_second,
                 const std::function<bool()>& stop = {});

} // namespace isomotion::sequence
