// What rounding adds to a point and to a direction, in each coordinate; what it adds to the ends of
// the part in the bounds; how far from its place a root may be proved.
uniform vec4 tube;
