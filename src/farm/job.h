// A sequence to be rendered by many processes: the call of `isomotion render` that all chunks
// share. Paths are absolute, since a worker may start anywhere.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace isomotion::farm {

struct Job {
    std::filesystem::path program; // isomotion itself
    std::filesystem::path folder;  // base for files that the options name
    std::filesystem::path scene;
    std::filesystem::path output; // out/name.####.png
    std::string frames;           // all of the sequence
    std::vector<std::filesystem::path> movies;
    std::vector<std::string> options;     // of render, except those for scene, frames and output
    std::vector<std::string> environment; // NAME=value, in addition to the worker's own
};

// The arguments that render the frames and keep those that are complete, so the call can be
// repeated. They also name all frames of the sequence: whichever chunk begins first records what
// was asked for, and `verify` misses the frames of chunks that never began.
std::vector<std::string> chunk_words(const Job& job, const std::string& frames);

// The same for all frames, in the order of a movie, at the end: renders missing ones, and joins the
// movie.
std::vector<std::string> joining_words(const Job& job, const std::string& frames);

// These words as one line for /bin/sh, which can run anywhere on a machine that sees the files.
std::string shell_line(const Job& job, const std::vector<std::string>& words);

// The sequence's name, from which names of files beside the frames are made: "name" for
// out/name.####.png, "frames" if the name is only a number.
std::string stem(const std::filesystem::path& output);

} // namespace isomotion::farm
