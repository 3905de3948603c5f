// Writes as depth whether the eye's ray ended on a surface that mirrors the others: MIRRORS has a bit for each
// of those. See march/mask.frag.
uniform sampler2D surface_texture_1;
uniform sampler2D surface_texture_3;

void main() {
    ivec2 at = ivec2(pixel_centre);
    int k = int(IM_TEXEL(surface_texture_3, at).z);
    int verdict = int(IM_TEXEL(surface_texture_1, at).w) & 7;
    gl_FragDepth = on_surface(verdict) && ((MIRRORS >> k) & 1) != 0 ? 1.0 : 0.0;
}
