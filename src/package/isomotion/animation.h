// Converts a frame's number to the values that the frame shows.
#pragma once

#include "animation/frame_range.h"
#include "animation/timeline.h"
