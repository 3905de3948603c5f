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

#ifdef HESSIAN
// Bounds F and its slope over a piece of the rays. The slope is also bounded by its value in the
// middle and its change from there. For a long polynomial, whose terms cancel, that is far tighter.
REAL4 bounds_of_piece(ProofRay ray, REAL low, REAL high) {
    Box all = box_around(ray, low, high);
    Box d = directions_about(ray);
    REAL2 f, slope, bx, by, bz;
    field_hessian_interval(all.x, all.y, all.z, d.x, d.y, d.z, f, slope, bx, by, bz);
    precise REAL middle = 0.5 * (low + high);
    precise REAL3 p = ray_point(ray, middle);
    REAL2 there = field_directional_interval(REAL2(p.x), REAL2(p.y), REAL2(p.z), d.x, d.y, d.z).zw;
    // The slope's change along this ray, and its change aside, to the other rays.
    REAL2 along = im_add(im_add(im_scale(ray.direction.x, bx), im_scale(ray.direction.y, by)),
                         im_scale(ray.direction.z, bz));
    precise REAL aside = im_abs(bx).y + im_abs(by).y + im_abs(bz).y;
    precise REAL off = 0.500001 * (high - low) * im_abs(along).y + 1.000001 * tube.x * aside;
    REAL2 centred = im_add(there, REAL2(-off, off));
    return REAL4(f, max(slope.x, centred.x), min(slope.y, centred.y));
}
#else
// Bounds F and its slope over a piece of the rays, over the box around it.
REAL4 bounds_of_piece(ProofRay ray, REAL low, REAL high) {
    return bounds_over(ray, box_around(ray, low, high));
}
#endif
