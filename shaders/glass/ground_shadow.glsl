// Loads the results of shadow rays from the ground seen through glass.
uniform sampler2D glass_shadow_texture;

float arrives(int k) {
    int hidden = int(texelFetch(glass_shadow_texture, ivec2(pixel_centre), 0).y);
    return ((hidden >> k) & 1) == 0 ? 1.0 : 0.0;
}
