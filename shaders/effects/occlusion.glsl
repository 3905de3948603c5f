#ifdef SURFACE
// What all surfaces leave of the light from everywhere, see surfaces/occlusion.frag.
uniform sampler2D occlusion_texture;

float openness(SurfacePoint p) {
    return p.on_ground ? 1.0 : IM_TEXEL(occlusion_texture, ivec2(pixel_centre)).x;
}
#else
// Ambient occlusion after Evans 2006. Along the normal of an open plane the distance to it grows as
// fast as the sample moves away. Where |F| / |grad F| grows less, something is near.
uniform vec4 occlusion; // reach in formula units, strength

float openness(SurfacePoint p) {
    const int samples = 5;
    float missing = 0.0, most = 0.0;
    for (int k = 1; k <= samples; ++k) {
        float way = clamp(occlusion.x, 1.0e-30, 1.0e30) * float(k) / float(samples);
        float f = field(p.position + way * p.normal) * (p.inside ? -1.0 : 1.0);
        float off = f / max(p.steepness, 1.0e-30);
#ifdef SECTIONS
        off = distance_to_rest(p.position + way * p.normal, p.inside, off);
#endif
        float distance = clamp(off, 0.0, way);
        float weight = exp2(-float(k));
        if (!im_is_nan(f)) missing += weight * (way - distance) / way;
        most += weight;
    }
    return p.on_ground ? 1.0 : 1.0 - occlusion.y * missing / most;
}
#endif
