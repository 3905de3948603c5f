// Colours of this surface as it is seen in a mirror, which is on any surface; or where paths ended on it,
// and of the ground, with what shadow rays took there.
layout(location = 0) out vec4 seen;

uniform sampler2D mirrored_texture_3;

void main() {
    SurfacePoint q = load_mirrored();
    bool is_own = int(IM_TEXEL(mirrored_texture_3, ivec2(pixel_centre)).z) == SURFACE;
    if (!is_own || !(is_on_surface(q) || q.on_ground)) discard;
#ifdef FOLLOWS_PATHS
    seen = vec4(seen_again(q, hit_of(q), load_path().direction), shadows_here());
#else
    vec3 direction = reflect(pixel_ray().direction, load_surface().normal);
    seen = vec4(seen_again(q, hit_of(q), direction), 1.0);
#endif
}
