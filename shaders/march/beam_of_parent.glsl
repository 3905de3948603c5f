// Beams within larger ones, which PARENT_BLOCK pixels across.
uniform sampler2D beam_texture;

// The part of tau, and the first piece to try.
vec4 parent_part() {
    vec4 parent = texelFetch(beam_texture, ivec2(pixel_centre) * BLOCK / PARENT_BLOCK, 0);
#ifdef LISTS
    enter_list(parent.zw);
#endif
    return vec4(parent.xy, 2.0 * beam.z, 0.0);
}
