// A model's slope within 0.85 of its piece's half to both sides of the middle, in s.
//
// Along each ray what a model leaves out is the difference of two polynomials in s of degree
// MODEL_DEGREE at most, so one itself. By Bernstein's inequality its slope is no more than
// MODEL_DEGREE / sqrt(1 - s^2), 1.9 MODEL_DEGREE here, times the most that it comes to within the
// piece.
//
// What the points of another of the rays add is more than that by (aside + s turn) times linear
// functions of s, which come to 1 at most within the piece. So do their slopes, which are no more
// than the rays' directions differ, either.
#define SLOPE_OF_REST (1.9 * float(MODEL_DEGREE))
