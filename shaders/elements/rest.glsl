// Bounds, for proofs, of what lists leave out of F's sums.
//
// At each place, the list of its cell leaves a number out of a sum, at most the grid's bound L in
// size. In the next cell along a ray this number may differ by 2 L. Statements about F hold for all
// numbers up to 64 L. So they still hold for the right one after slopes led from a place to the
// ends of two boxes, over at most 12 cells each (cells_of_box.glsl), and aside by the ray's
// rounding.
vec2 bounds_of_rest(float bound) { return 64.0 * vec2(-bound, bound); }
