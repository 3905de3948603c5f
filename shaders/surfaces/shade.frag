// The picture where this surface is seen, and for the first surface also where none is:
// effects/shade.frag, with the evaluations that all surfaces took.

layout(location = 0) out vec4 color;
layout(location = 1) out uvec4 record; // see shade/record.glsl

void main() {
    vec4 end = texelFetch(surface_texture_3, ivec2(pixel_centre), 0);
    if (int(end.z) != SURFACE) discard;
    Ray ray = pixel_ray();
    SurfacePoint p = load_surface();
    Hit hit = hit_of(p);
    if (is_on_surface(p) || p.on_ground) {
        color = vec4(shade(ray, p, hit), 1.0);
    } else if (p.verdict == VERDICT_NAN) {
        color = vec4(1.0, 0.0, 1.0, 1.0); // no pixel lies silently: magenta,
    } else if (p.verdict == VERDICT_STEP_LIMIT) {
        color = vec4(1.0, 0.8, 0.0, 1.0); // amber
    } else {
        color = sky(ray.direction);
    }
    record = uvec4(packed_record(p.verdict, int(end.y)), further_record(p));
    write_channels(ray, hit, p.verdict);
}
