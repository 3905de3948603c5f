// The part of the light from everywhere that this surface leaves at what is seen, which is on any
// surface. It is computed as in effects/occlusion.glsl, and the least of the surfaces so far
// counts.
layout(location = 0) out vec4 open;

uniform vec4 occlusion; // reach in formula units, strength

// Off another surface, |F| / |grad F| where F has the sign that it has at the place; behind it, none.
float openness_by(SurfacePoint p, bool is_own) {
    const int samples = 5;
    float side = p.inside ? -1.0 : 1.0;
    float missing = 0.0, most = 0.0;
    for (int k = is_own ? 1 : 0; k <= samples; ++k) {
        float way = clamp(occlusion.x, 1.0e-30, 1.0e30) * float(k) / float(samples);
        vec3 place = p.position + (k == 0 ? p.offset : way) * p.normal;
        float f = field(place);
        if (k == 0) {
            side = f < 0.0 ? -1.0 : 1.0;
            continue;
        }
        float steepness = is_own ? p.steepness : length(field_gradient(place));
        float off = f * side / max(steepness, 1.0e-30);
#ifdef SECTIONS
        off = distance_to_rest(place, side < 0.0, off);
#endif
        float distance = clamp(off, 0.0, way);
        float weight = exp2(-float(k));
        if (!im_is_nan(f) && !im_is_nan(off)) missing += weight * (way - distance) / way;
        most += weight;
    }
    return 1.0 - occlusion.y * missing / most;
}

void main() {
    SurfacePoint p = load_surface();
    bool is_own = int(IM_TEXEL(surface_texture_3, ivec2(pixel_centre)).z) == SURFACE;
    float all = open_before();
    if (is_on_surface(p)) all = min(all, openness_by(p, is_own));
    open = vec4(all, 0.0, 0.0, 0.0);
}
