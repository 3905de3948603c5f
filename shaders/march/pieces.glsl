// Encloses a piece of a ray in a box, for interval arithmetic. Bounds may be NaN; comparisons are
// written so that NaN counts as 'may hold 0'.
void box_over(Ray ray, vec2 piece, out vec2 x, out vec2 y, out vec2 z) {
    x = im_add(vec2(ray.anchor.x), im_scale(ray.direction.x, piece));
    y = im_add(vec2(ray.anchor.y), im_scale(ray.direction.y, piece));
    z = im_add(vec2(ray.anchor.z), im_scale(ray.direction.z, piece));
}

bool excludes_0(vec2 a) {
    return a.x > 0.0 || a.y < 0.0;
}

#if defined(BOUNDS_PIECES) || defined(ROUGH)
// Bounds F and its slope over a piece of a ray, in interval arithmetic.
struct Bounds {
    vec2 value; // of F
    vec2 derivative; // of dF/dt, and of every difference quotient in the piece
};

Bounds bounds_over(Ray ray, vec2 piece, vec3 direction) {
    vec2 x, y, z;
    box_over(ray, piece, x, y, z);
    vec4 f = field_directional_interval(x, y, z, vec2(direction.x), vec2(direction.y), vec2(direction.z));
    return Bounds(f.xy, f.zw);
}
#endif
