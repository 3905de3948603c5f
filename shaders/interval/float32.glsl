// Makes the files of shaders/interval/ that follow work on intervals of floats. Needs bits.glsl.
//
// These files are written for numbers of type REAL. A shader may contain them twice: once for
// floats and once for doubles, after float64.glsl.
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
#define REAL float
#define REAL2 vec2
#define REAL3 vec3
#define REAL4 vec4
#define IM_INFINITY uintBitsToFloat(0x7f800000u)
#define IM_LARGEST 3.402823466e38
#define IM_SMALLEST 1.17549435e-38
#define IM_STEP 4.70197740e-38          // 2^-124
#define IM_ROUNDING 8.94069672e-8       // 1.5 * 2^-24
#define IM_DRIVER_ERROR 4.76837158e-7   // of quotients and roots: 2^-21
#define IM_MOST_DIVISOR 4.25352959e37   // 2^125
#define IM_SPLITTER 4097.0              // 2^12 + 1
