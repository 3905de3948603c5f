// The one way from a frame's number to the values it shows.
#pragma once

#include "animation/frame_range.h"
#include "animation/timeline.h"
