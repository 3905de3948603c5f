// A sweep's measurements as tables, pictures and a page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "accuracy/measure.h"

namespace isomotion::accuracy {

struct Report {
    std::string title, machine; // of the scene; the machine and driver
    scene::Isolation isolation; // the scene's own
    std::vector<int> frames;
    int width = 0, height = 0;
    std::vector<Measurement> measurements;
};

// For the terminal: one line per setting, with marks on the front.
std::string table(const Report& report);

std::string csv(const Report& report);
std::string json(const Report& report);

// The names of the files that write() writes for so many measurements.
std::vector<std::string> files_written(std::size_t measurements);

// Writes accuracy.csv, accuracy.json, wrong-NN.png for each setting, accuracy.svg and accuracy.png
// (wrong pixels against time, by gnuplot) and index.html with all of these. Makes the folder.
// Throws base::FileError, and an Error (device) that says what to install.
void write(const Report& report, const std::filesystem::path& folder);

} // namespace isomotion::accuracy
