// Events of a scene's topology and Betti numbers, proved, without GL; timeline files and checks.
#pragma once

#include "topology/analyse.h"
#include "topology/timeline/expectation.h"
#include "topology/timeline/summary.h"
#include "topology/timeline/timeline_file.h"
