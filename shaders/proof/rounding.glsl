// The rounding of a point and of a direction, in each coordinate; the rounding of the ends of the
// part in the bounds; the largest distance of a proved root from the one found.
uniform vec4 tube;
#define BOUNDS_ROUNDING tube.z
