// What lists leave out of F's sums, for proofs.
//
// Left out of a sum is a number at each place, at most the grid's bound L in size, and another one
// by each cell's list: where a ray goes on in the next cell the number may change by 2 L. What is
// told of F holds for all numbers up to 64 L. So it is still told of the right one where slopes led
// from there to the ends of two boxes, over at most 12 cells each (cells_of_box.glsl), and aside by
// what rounding makes of the ray.
vec2 bounds_of_rest(float bound) { return 64.0 * vec2(-bound, bound); }
