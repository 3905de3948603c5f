// Frames of a scene, drawn with OpenGL in a window or without one, and as files.
#pragma once

#include "base/file.h"
#include "gpu/error.h"
#include "image/encode.h"
#include "render/renderer.h"
