// Events of a scene's topology and Betti numbers, proved, without GL; timeline files and checks.
#pragma once

#include "topology/analyse.h"
#include "topology/expectation.h"
#include "topology/summary.h"
#include "topology/timeline_file.h"
