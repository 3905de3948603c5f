// Tells whether this surface's matter is behind the end of a ray. Surfaces draw over each other,
// the one with the least rank last.
layout(location = 0) out vec4 beyond; // 1 + index

void main() {
    SurfacePoint p = load_surface();
    if (!is_on_surface(p)) discard;
    int on = int(IM_TEXEL(surface_texture_3, ivec2(pixel_centre)).z);
    bool is_there;
    if (on == SURFACE && p.steepness >= 0.0) { // not at its bounds
        is_there = !p.inside;
    } else {
        vec3 place = p.position - p.offset * p.normal;
        vec2 bounds = clip_to_bounds(place, -p.normal);
        is_there = bounds.x <= 0.0 && bounds.y >= 0.0 && bounds.x < bounds.y && is_in_matter(place);
    }
    if (!is_there) discard;
    beyond = vec4(float(SURFACE + 1), 0.0, 0.0, 0.0);
}
