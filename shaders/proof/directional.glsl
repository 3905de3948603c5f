// The directions of the rays, and bounds on F and its slope along them.
Box directions_about(ProofRay ray) {
    precise REAL3 least = ray.direction - tube.y;
    precise REAL3 most = ray.direction + tube.y;
    return Box(REAL2(least.x, most.x), REAL2(least.y, most.y), REAL2(least.z, most.z));
}

REAL4 bounds_over(ProofRay ray, Box p) {
    Box d = directions_about(ray);
    return field_directional_interval(p.x, p.y, p.z, d.x, d.y, d.z);
}
