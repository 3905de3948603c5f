// Boxes that hold the points of all rays that float32 may make of the pixel's ray: of the one here
// and of the one that was marched (src/truth/tube.h).

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
