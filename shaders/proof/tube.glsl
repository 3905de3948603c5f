// Boxes that hold the points of all rays that float32 may make of the pixel's ray: of the one here
// and of the one that was marched (src/truth/tube.h).

// What rounding adds to a point and to a direction, in each coordinate; what it adds to the ends of
// the part in the bounds; how far from its place a root may be proved.
uniform vec4 tube;
uniform float shortest_piece;

struct Box {
    REAL2 x, y, z;
};

// Around the points from t = low to high.
Box box_around(ProofRay ray, REAL low, REAL high) {
    precise REAL3 a = ray.anchor + low * ray.direction;
    precise REAL3 b = ray.anchor + high * ray.direction;
    precise REAL3 least = min(a, b) - tube.x;
    precise REAL3 most = max(a, b) + tube.x;
    return Box(REAL2(least.x, most.x), REAL2(least.y, most.y), REAL2(least.z, most.z));
}

Box directions_about(ProofRay ray) {
    precise REAL3 least = ray.direction - tube.y;
    precise REAL3 most = ray.direction + tube.y;
    return Box(REAL2(least.x, most.x), REAL2(least.y, most.y), REAL2(least.z, most.z));
}

// F and its slope along the rays.
REAL4 bounds_over(ProofRay ray, Box p) {
    Box d = directions_about(ray);
    return field_along_interval(p.x, p.y, p.z, d.x, d.y, d.z);
}
