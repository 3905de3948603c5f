// A sequence to be rendered by many: the call of `isomotion render` that all chunks share. Paths
// are absolute, since a worker may start anywhere.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace isomotion::farm {

struct Job {
    std::filesystem::path program; // isomotion itself
    std::filesystem::path folder;  // from where files are named that the options name
    std::filesystem::path scene;
    std::filesystem::path output; // out/name.####.png
    std::vector<std::filesystem::path> movies;
    std::vector<std::string> options;     // of render, but those that say what is rendered where
    std::vector<std::string> environment; // NAME=value, beside what the worker has
};

// Renders the frames, keeping those that are whole: it may be called again and again.
std::vector<std::string> chunk_words(const Job& job, const std::string& frames);

// The same for all frames at the end: renders what is missing, and joins the movie.
std::vector<std::string> joining_words(const Job& job, const std::string& frames);

// These words as one line for /bin/sh, to be run anywhere on a machine that sees the files.
std::string shell_line(const Job& job, const std::vector<std::string>& words);

// The sequence's name, of which names of files beside the frames are made: "name" of
// out/name.####.png, "frames" where the number is all there is.
std::string stem(const std::filesystem::path& output);

} // namespace isomotion::farm
