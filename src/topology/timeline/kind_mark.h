// How pictures mark the kinds of events: a colour, and a triangle that points up or down.
//
// Colours are those of Okabe and Ito (2008) and Tol's muted scheme, which colour-blind people can
// distinguish. Colour is never the only difference between marks.
#pragma once

#include <span>

#include "topology/timeline/event.h"

namespace isomotion::topology {

struct KindMark {
    Kind kind;
    const char* colour; // "#rrggbb"
    int change; // 1: adds to one of the Betti numbers; -1: takes away; 0: neither, or unknown
};

// One for each kind, in the order in which pictures list them.
std::span<const KindMark> kind_marks();
const KindMark& mark_of(Kind kind);

} // namespace isomotion::topology
