// What all surfaces leave of the light from everywhere, see occlusion.frag.
uniform sampler2D occlusion_texture;

float openness(SurfacePoint p) {
    return p.on_ground ? 1.0 : IM_TEXEL(occlusion_texture, ivec2(pixel_centre)).x;
}
