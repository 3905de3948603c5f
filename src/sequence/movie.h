// A sequence joined to a movie.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <stdexcept>

#include "image/frame.h"

namespace isomotion::sequence {

// A movie could not be made; ffmpeg's own words are in the message where it had any.
class MovieError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Throws a MovieError unless the name's extension is one of the three below and its format holds
// that rate: known before the first of many pictures is rendered.
void check_movie(const std::filesystem::path& movie, image::Rational frames_per_second);

// Throws a MovieError where there is no ffmpeg.
void expect_ffmpeg();

// Makes a movie of pictures of one size, in the order given, with the ffmpeg program on PATH:
// `.mp4` (H.264), `.webm` (VP9) or `.gif`. Coverage shows black. Odd sizes are made even, as H.264
// and VP9 need them, by repeating the last column or row. The same pictures give the same bytes
// with the same ffmpeg. The file appears only when it is complete; false if `stop` said so before.
//
// Throws a MovieError; what decode() throws for a picture that cannot be read; a FileError if the
// movie has no place to be written; a std::system_error if ffmpeg is there but does not start.
bool write_movie(const std::filesystem::path& movie,
                 std::span<const std::filesystem::path> pictures, image::Rational frames_per_second,
                 const std::function<bool()>& stop = {});

} // namespace isomotion::sequence
