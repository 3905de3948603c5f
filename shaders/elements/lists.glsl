// Chooses the elements that a proof sums over where beams have lists: one list for the whole ray,
// or all elements. The sum that a list leaves out is a function of the place, at most a number L in
// size. Proofs hold with any number up to L, in size, added to the sum that is left. So if none of
// these F has a root in a part of the ray, neither has F. If each has one root within an eighth of
// a pixel, with the same change of sign, so has F.
//
// L covers the three lists, one made from another, each of which may leave out LEFT_OUT of the
// sum's value at roots (beam_list.glsl), bounded anywhere in its part. A block's proof is continued
// by those of its rays, which may use another list: then the sums of both proofs differ by both
// numbers, see begin.frag. Hence L takes 12 LEFT_OUT: three times 3, and some more.

vec2 array0_rest[1] = vec2[1](vec2(0.0));

void enter_all_elements() {
    enter_list(vec2(float(array_counts[0].x), 0.0));
    array0_rest[0] = vec2(0.0);
}

// Enters a list whose part holds this box, at least where the box meets the bounds.
void enter_list_of_proof(vec2 list, REAL2 x, REAL2 y, REAL2 z) {
    REAL2 rest, factor;
    rest_and_factor_interval(x, y, z, rest, factor);
    REAL least = im_abs(factor).x, most = 12.0 * LEFT_OUT * im_abs(rest).y;
    float left_out = float(most / least) * 1.00001;
    bool is_bounded = least > 1.0e-30 && left_out < IM_SATURATION; // and not NaN
    if (!is_bounded) {
        enter_all_elements();
        return;
    }
    enter_list(list);
    array0_rest[0] = vec2(-left_out, left_out);
}
