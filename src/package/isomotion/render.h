// Frames of a scene, drawn with OpenGL in a window or without one, and as files.
#pragma once

#include "gpu/error.h"
#include "image/encode.h"
#include "image/file.h"
#include "render/renderer.h"
