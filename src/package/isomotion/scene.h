// Scene files, and a scene at one time.
#pragma once

#include "scene/data_folder.h"
#include "scene/rays.h"
#include "scene/reading/load.h"
#include "scene/scene_at.h"
