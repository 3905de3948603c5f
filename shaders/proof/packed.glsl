// Rays whose proofs go on are few and apart, so that passes draw them packed together: 16 of the list are
// a square of 4 x 4 pixels, which software renderers go through in step.
uniform sampler2D open_texture; // of each ray its pixel and its proof, see src/render/packed_rays.h
uniform int squares_across;     // 0: each ray is drawn at its pixel

#undef pixel_centre

ivec2 open_texel() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int square = at.y / 4 * squares_across + at.x / 4;
    int ray = 16 * square + 4 * (at.y % 4) + at.x % 4;
    return ivec2(2 * (ray % PACKED_ACROSS), ray / PACKED_ACROSS);
}

vec2 centre_of_ray() {
    if (squares_across == 0) return gl_FragCoord.xy;
    return IM_TEXEL(open_texture, open_texel()).xy + 0.5;
}

vec2 pixel_centre = centre_of_ray();
