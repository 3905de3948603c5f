// Proves the roots of all rays of a block, where all of them hit, by the model of the piece that
// holds these: Newton's step from where each was found stays close to it, see prove.glsl.

// How far F can be from 0 at the rays' ends.
float uncertain_at_ends(Ends ends, Piece piece, Model f) {
    float most = 0.0;
    for (int k = 0; k < RAYS; ++k) {
        vec2 at = place_in_block(k);
        float s = (ends.taus[k] - dot(piece.lean, at) - piece.middle) / piece.half_length;
        float value = f.c + dot(f.l, vec3(at, s)) + dot(f.d, vec3(at * at, s * s)) +
                      dot(f.o, vec3(at.x * at.y, s * at));
        most = max(most, abs(value));
    }
    return md_up(most + f.error + 64.0 * IM_ROUNDING * md_size(f));
}

// `slope`: the least of F in tau over the piece, whose ends keep a distance of 2 tube.w and
// `margin` from all roots.
bool proves_roots(Beam boxes, Ends ends, Piece piece, Model f, float slope, float margin) {
    float leans = abs(piece.lean.x) + abs(piece.lean.y), reaches = piece.half_length + leans;
    // How far a tau may be off: its length, its quotient and the place of its s, 60 ulps at most.
    float rounding = 4.0e-6 * (abs(piece.middle) + reaches);
    float off = uncertain_at_ends(ends, piece, f) / slope * 1.000002 + rounding;
    vec2 x, y, z;
    box_around(boxes, piece.middle - reaches, piece.middle + reaches, x, y, z);
    return slope > 0.0 && off * ends.farthest_eye * 1.000002 <= tube.w &&
           ends.first - leans - off > margin - 1.0 && holds_within_bounds(x, y, z);
}
