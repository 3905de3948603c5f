// What a frame could save by what the frame before it found: temporal coherence, at its best.
//
// Every frame proves anew where its rays begin (beams). A scheme that carries starts from frame to
// frame has to prove that they still hold; a frame that gets its own starts for nothing takes less
// time than with any such scheme. With starts for single pixels its rays begin beside their roots
// and those without roots end at once: less than if roots were carried too. And the starts of the
// frame before, taken as they are, tell what goes wrong without a proof.
#pragma once

#include <string>
#include <vector>

#include "methods/contest.h"

namespace isomotion::bench {

enum class Known {
    nothing,      // all anew, as the product does
    by_pixel,     // all anew, with a start for each pixel
    last_starts,  // those of the frame before, unproved
    own_starts,   // the frame's own, by blocks of 8 pixels
    own_by_pixel, // the frame's own, by pixels
};
const char* name(Known known);

struct Carried {
    Known known;
    Count count;
    Timing timing;
    double gain = 0; // time with nothing known over this one's
};

struct Coherence {
    std::string subject;
    int size = 0, frames = 0;
    std::vector<Carried> rows;
};

// Measures with the method hermite. Times are of frames whose starts are there already. Throws
// std::logic_error if the picture takes more than one tile.
Coherence coherence(gpu::Context& context, const Certified& on, int repeat);

} // namespace isomotion::bench
