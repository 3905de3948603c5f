// Pieces of a block's beam, and models of F over them.

// The rays through the centres of a block's pixels, in the plane of the anchors.
struct Across {
    vec3 middle, right, up; // from the middle to the outer pixels
};

Across across_block(ivec2 block) {
    vec2 half_size = 0.5 * float(BLOCK - 1) * picture.xy;
    vec2 at = (vec2(block * BLOCK) + picture.zw + 0.5) * picture.xy - 1.0 + half_size;
    half_size += around_middles * picture.xy;
    return Across(at.x * ray_right.xyz + at.y * ray_up.xyz, half_size.x * ray_right.xyz,
                  half_size.y * ray_up.xyz);
}

// A piece's points, in tau: middle + s half_length + u (lean.x + s turn.x) + v (lean.y + s turn.y)
struct Piece {
    float middle, half_length;
    vec2 lean, turn;
};

Model coordinate_of(Piece piece, float origin, float axis, float across, float right, float up) {
    precise float c = origin + piece.middle * axis;
    precise vec3 l = axis * vec3(piece.lean, piece.half_length);
    precise vec2 turn = axis * piece.turn;
    // The part of a coordinate that stays along the beam, and the part that widens with it.
    precise float widens = 1.0 + ray_axis.w * piece.middle;
    precise vec3 widening = ray_axis.w * vec3(piece.lean, piece.half_length);
    precise vec2 widening_turn = ray_axis.w * piece.turn;
    precise float middle = c + widens * across;
    precise vec3 linear = l + widening * across + widens * vec3(right, up, 0.0);
    precise vec3 squares = vec3(widening.xy * vec2(right, up), 0.0);
    precise vec3 others = vec3(widening.x * up + widening.y * right,
                               turn + widening_turn * across + widening.z * vec2(right, up));
    float cubic = md_sum(vec3(widening_turn, 0.0)) * (abs(right) + abs(up));
    // beam.w includes the rounding of all this, except for the terms that lean.
    float off = beam.w + cubic + 8.0 * IM_ROUNDING * (abs(middle) + md_sum(linear) + md_sum(others));
    // Rays are straight, so their error is linear in s.
    return md_model(middle, linear, squares, others, md_up(off), md_up(off));
}

Model model_of_piece(Across way, Piece piece) {
    vec3 o = ray_origin.xyz, a = ray_axis.xyz, m = way.middle, r = way.right, u = way.up;
    return field_model(coordinate_of(piece, o.x, a.x, m.x, r.x, u.x),
                       coordinate_of(piece, o.y, a.y, m.y, r.y, u.y),
                       coordinate_of(piece, o.z, a.z, m.z, r.z, u.z));
}
