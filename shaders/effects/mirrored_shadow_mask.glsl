// Loads the results of shadow rays that start where mirrored rays ended.
uniform sampler2D mirrored_shadow_texture;

float mirrored_visibility(int k) {
    int hidden = int(IM_TEXEL(mirrored_shadow_texture, ivec2(pixel_centre)).y);
    return ((hidden >> k) & 1) == 0 ? 1.0 : 0.0;
}
