// A formula as an expression graph, evaluated in float, double and intervals, and as GLSL.
#pragma once

#include "formula/enclosure.h"
#include "formula/field.h"
#include "formula/graph/parser.h"
