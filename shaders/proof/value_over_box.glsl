// Bounds F at a point of the rays by its natural bound over all of them.
REAL2 value_at(ProofRay ray, REAL t) {
    Box p = box_around(ray, t, t);
    return field_interval(p.x, p.y, p.z);
}
