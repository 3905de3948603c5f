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
