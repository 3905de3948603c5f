// Loads the results of the shadow rays.
uniform sampler2D shadow_texture;

float visibility(int k) {
    int hidden = int(texelFetch(shadow_texture, ivec2(pixel_centre), 0).y);
    return ((hidden >> k) & 1) == 0 ? 1.0 : 0.0;
}
