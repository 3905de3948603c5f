// Shades the ends of the rays, for scenes with more than a plain light. Of several surfaces each shades
// where it is seen, and the first one also where none is.

layout(location = 0) out vec4 color;
layout(location = 1) out uvec4 record; // see shade/hit.glsl

// The colour where no surface is seen.
vec4 color_beside(Ray ray) {
    vec4 far = sky(ray.direction);
#ifdef FOLLOWS_PATHS
    return vec4(with_path(far.rgb), load_path().own > 0.0 ? far.a : 1.0); // the eye may be in glass
#elif defined(GLASS)
    return far * vec4(load_path().weight, 1.0);
#else
    return far;
#endif
}

void main() {
#ifdef SURFACE
    vec4 end = IM_TEXEL(surface_texture_3, ivec2(pixel_centre));
    if (int(end.z) != SURFACE) discard;
    int evaluations = int(end.y); // of all surfaces
#else
    int evaluations = load_state().evaluations;
#endif
    Ray ray = pixel_ray();
    SurfacePoint p = stored_surface();
    Hit hit = hit_of(p);
    if (is_on_surface(p) || p.on_ground) {
        color = vec4(shade(ray, p, hit), 1.0);
    } else if (p.verdict == VERDICT_NAN) {
        color = vec4(1.0, 0.0, 1.0, 1.0); // no pixel lies silently: NaN is magenta,
    } else if (p.verdict == VERDICT_STEP_LIMIT) {
        color = vec4(1.0, 0.8, 0.0, 1.0); // the step limit amber
    } else {
        color = color_beside(ray);
    }
    record = uvec4(packed_record(p.verdict, evaluations), further_record(p));
    write_channels(ray, hit, p.verdict);
}
