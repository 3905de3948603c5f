// The tables as pictures.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "methods/tables.h"

namespace isomotion::bench {

// Makes plots by gnuplot, as SVG: wrong.svg (wrong pixels against time, every surface), ratio.svg
// (against the sign test at equal accuracy, surface by surface), resolution.svg, blobs.svg,
// degree.svg and lights.svg (cost of a ray, and what evaluations of the field alone would take at
// the machine's peak). What there are no results for is not drawn. Throws an Error (device).
void plot(const Results& results, const std::filesystem::path& folder);

} // namespace isomotion::bench
