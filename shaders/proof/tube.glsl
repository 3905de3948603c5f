// Boxes around the points of all rays that float32 may make of the pixel's ray: the one here and
// the one that was marched (src/roots/tube.h).

uniform float shortest_piece;

struct Box {
    REAL2 x, y, z;
};

// Encloses the points from t = low to high.
Box box_around(ProofRay ray, REAL low, REAL high) {
    precise REAL3 a = ray.anchor + low * ray.direction;
    precise REAL3 b = ray.anchor + high * ray.direction;
    precise REAL3 least = min(a, b) - tube.x;
    precise REAL3 most = max(a, b) + tube.x;
    return Box(REAL2(least.x, most.x), REAL2(least.y, most.y), REAL2(least.z, most.z));
}
