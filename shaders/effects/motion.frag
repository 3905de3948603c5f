// Evaluates F and its gradient at another time, where the rays of this time ended. The values from
// a little earlier and a little later give the surface's motion (src/render/motion.h).
layout(location = 0) out vec4 field_there;

// Transforms a point to formula coordinates of the other time, which move with the placement.
uniform vec4 move_x;
uniform vec4 move_y;
uniform vec4 move_z;

void main() {
    Ray ray = pixel_ray();
    RayState s = load_state();
    field_there = vec4(0.0);
    if (s.verdict != VERDICT_HIT) return;
    vec4 p = vec4(ray_point(ray, s.low), 1.0);
    vec3 q = vec3(dot(move_x, p), dot(move_y, p), dot(move_z, p));
    field_there = vec4(field_gradient(q), field(q));
#ifdef SECTIONS
    // Sections of the other time.
    int cap = cap_of(s);
    if (cap >= 0) field_there = vec4(section_gradient(cap, q), section_value(cap, q));
#endif
}
