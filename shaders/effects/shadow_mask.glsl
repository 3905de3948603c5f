// Loads the results of the shadow rays.
uniform sampler2D shadow_texture;

float visibility(int k) {
    int hidden = int(IM_TEXEL(shadow_texture, ivec2(pixel_centre)).y);
    return ((hidden >> k) & 1) == 0 ? 1.0 : 0.0;
}

#ifdef MIRRORED_SHADOWS
// Of those that start where mirrored rays ended.
uniform sampler2D mirrored_shadow_texture;

float mirrored_visibility(int k) {
    int hidden = int(IM_TEXEL(mirrored_shadow_texture, ivec2(pixel_centre)).y);
    return ((hidden >> k) & 1) == 0 ? 1.0 : 0.0;
}
#endif
#ifdef GLASS_SHADOWS
// Of those from the ground seen through glass.
uniform sampler2D glass_shadow_texture;

float arrives(int k) {
    int hidden = int(IM_TEXEL(glass_shadow_texture, ivec2(pixel_centre)).y);
    return ((hidden >> k) & 1) == 0 ? 1.0 : 0.0;
}
#endif
