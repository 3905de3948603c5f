// What mirrored rays see of the surfaces, where there is any: see seen.frag.
uniform sampler2D seen_texture;

vec4 seen_in_mirror() {
    return IM_TEXEL(seen_texture, ivec2(pixel_centre));
}
