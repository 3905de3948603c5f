// im_floats_around: an interval of floats around one of doubles. Needs float64.glsl.
//
// Functions without a version for doubles use that for floats, in the files of this folder. Their
// bounds hold, and are as tight as those of floats.
vec2 im_floats_around(dvec2 a) {
    dvec2 inner = clamp(a, dvec2(-3.40282347e38), dvec2(3.40282347e38));
    precise vec2 r = vec2(inner);
    // Covers any rounding, and a flush to 0.
    precise vec2 margin = abs(r) * 2.38418579e-7 + 4.70197740e-38;
    precise vec2 outer = vec2(r.x - margin.x, r.y + margin.y);
    outer = vec2(IM_SELECT(a.x >= 0.0, max(outer.x, 0.0), outer.x),
                 IM_SELECT(a.y <= 0.0, min(outer.y, 0.0), outer.y));
    return vec2(IM_SELECT(dvec2(r).x == a.x, r.x, outer.x),
                IM_SELECT(dvec2(r).y == a.y, r.y, outer.y));
}
