// Rays whose proofs are open are drawn packed together, 16 to a square of 4 x 4 pixels, which software
// renderers go through in step: first the blocks of rays that no proof decided, then single rays.
uniform sampler2D open_texture; // of a block its number; of a ray its pixel, then its proof
uniform int squares_across, last_entry; // which stands in for those that squares and rows lack

#undef pixel_centre

ivec2 texel_of_list(int k) {
    return ivec2(k % LIST_ACROSS, k / LIST_ACROSS);
}

#ifdef WHOLE_BLOCKS
vec2 centre_of_ray() {
    ivec2 at = ivec2(gl_FragCoord.xy), square = at / PROVED_BLOCK;
    int k = min(square.y * squares_across + square.x, last_entry);
    vec2 block = IM_TEXEL(open_texture, texel_of_list(k)).xy;
    return float(PROVED_BLOCK) * block + vec2(at % PROVED_BLOCK) + 0.5;
}
#else
ivec2 texel_of_ray() {
    ivec2 at = ivec2(gl_FragCoord.xy), square = at / 4, within = at % 4;
    int k = 16 * (square.y * squares_across + square.x) + 4 * within.y + within.x;
    return texel_of_list(2 * min(k, last_entry));
}

vec2 centre_of_ray() {
    return IM_TEXEL(open_texture, texel_of_ray()).xy + 0.5;
}
#endif

vec2 pixel_centre = centre_of_ray();
