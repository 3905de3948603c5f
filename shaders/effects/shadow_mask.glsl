// Loads the results of the shadow rays.
uniform sampler2D shadow_texture;

float visibility(int k) {
    int hidden = int(IM_TEXEL(shadow_texture, ivec2(pixel_centre)).y);
    return ((hidden >> k) & 1) == 0 ? 1.0 : 0.0;
}
