// Chooses the elements that proofs go through where beams have lists of those that matter: those of
// one list all the way, or all elements. What a list leaves out of F's sum is one function of the
// place, at most a number in size. What is proved of F holds for every number up to that one, added
// to the sum. So if all of these F are free of roots in a part, so is F; if each has one root within
// an eighth of a pixel, with the same change of sign, so has F.
//
// The number: what the three lists, one made from another, may leave out at a root (beam_list.glsl),
// which is LEFT_OUT of what the sum is at roots, wherever in their part that is asked. A block's
// proof leads on to those of its rays, which may go by another list: then the sum is off by both of
// these numbers in what one has proved of it, see begin.frag. Hence three times 3, and some more.

vec2 array0_rest[1] = vec2[1](vec2(0.0));

void enter_all_elements() {
    enter_list(vec2(float(array_counts[0].x), 0.0));
    array0_rest[0] = vec2(0.0);
}

// A list whose part holds this box, at least where it meets the bounds.
void enter_list_of_proof(vec2 list, REAL2 x, REAL2 y, REAL2 z) {
    REAL2 rest, factor;
    rest_and_factor_interval(x, y, z, rest, factor);
    REAL least = im_abs(factor).x, most = 12.0 * LEFT_OUT * im_abs(rest).y;
    float left_out = float(most / least) * 1.00001;
    bool is_bounded = least > 1.0e-30 && left_out < IM_SATURATION; // and a number
    if (!is_bounded) {
        enter_all_elements();
        return;
    }
    enter_list(list);
    array0_rest[0] = vec2(-left_out, left_out);
}
