// The first beams: their part is all of the bounds.

// The part of tau, and the first piece to try.
vec4 parent_part(ivec2 block) {
    return vec4(beam.xy, 0.125 * (beam.y - beam.x), 0.0);
}
