// The tables as pictures.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "methods/tables.h"

namespace isomotion::bench {

// No program to plot with. The message says what to install.
class PlotError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// By gnuplot, as SVG: wrong.svg (wrong pixels against time, every surface), ratio.svg (against the
// sign test at equal accuracy, surface by surface), resolution.svg and blobs.svg (cost of a ray).
// What there are no results for is not drawn. Throws PlotError.
void plot(const Results& results, const std::filesystem::path& folder);

} // namespace isomotion::bench
