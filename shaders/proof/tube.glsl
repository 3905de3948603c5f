// Boxes that hold the points of all rays that float32 may make of the pixel's ray: of the one here
// and of the one that was marched (src/truth/tube.h).

// What rounding adds to a point and to a direction, in each coordinate; what it adds to the ends of
// the part in the bounds; how far from its place a root may be proved.
uniform vec4 tube;
uniform float shortest_piece;

struct Box {
    vec2 x, y, z;
};

// Around the points from t = low to high.
Box box_around(Ray ray, float low, float high) {
    precise vec3 a = ray.anchor + low * ray.direction;
    precise vec3 b = ray.anchor + high * ray.direction;
    precise vec3 least = min(a, b) - tube.x;
    precise vec3 most = max(a, b) + tube.x;
    return Box(vec2(least.x, most.x), vec2(least.y, most.y), vec2(least.z, most.z));
}

// F and its slope along the rays.
vec4 bounds_over(Ray ray, Box p) {
    precise vec3 least = ray.direction - tube.y;
    precise vec3 most = ray.direction + tube.y;
    return field_along_interval(p.x, p.y, p.z, vec2(least.x, most.x), vec2(least.y, most.y),
                                vec2(least.z, most.z));
}
