// Frames of a scene exported to files that can be resumed, verified and joined to a movie.
#pragma once

#include "sequence/exporter.h"
#include "sequence/verification.h"
