// What follows in shaders/interval/ is on intervals of doubles. Needs bits.glsl.
//
// GLSL promises no more of doubles than of floats. That sums and products are rounded to the
// nearest, and by how much quotients and roots are off, is measured where they are used:
// src/render/doubles.h.
#undef REAL
#undef REAL2
#undef REAL3
#undef REAL4
#undef IM_INFINITY
#undef IM_LARGEST
#undef IM_SMALLEST
#undef IM_STEP
#undef IM_ROUNDING
#undef IM_DRIVER_ERROR
#undef IM_MOST_DIVISOR
#undef IM_SPLITTER
#define REAL double
#define REAL2 dvec2
#define REAL3 dvec3
#define REAL4 dvec4
// By their bits: NVIDIA's compiler rounds decimals to a neighbour of the nearest double.
#define IM_INFINITY packDouble2x32(uvec2(0u, 0x7ff00000u))
#define IM_LARGEST packDouble2x32(uvec2(0xffffffffu, 0x7fefffffu))
#define IM_SMALLEST packDouble2x32(uvec2(0u, 0x00100000u))     // 2^-1022
#define IM_STEP packDouble2x32(uvec2(0u, 0x00300000u))         // 2^-1020
#define IM_ROUNDING packDouble2x32(uvec2(0u, 0x3ca80000u))     // 1.5 * 2^-53
#define IM_DRIVER_ERROR packDouble2x32(uvec2(0u, 0x3cd00000u)) // of quotients and roots: 2^-50
#define IM_MOST_DIVISOR packDouble2x32(uvec2(0u, 0x7fc00000u)) // 2^1021
#define IM_SPLITTER 134217729.0LF                              // 2^27 + 1
