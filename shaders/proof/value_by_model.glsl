// Bounds F at a point of the rays: its value on this ray, widened by its rounding, and by its
// gradient for the others.
PointModel coordinate_at(REAL anchor, REAL direction, REAL t, REAL3 axis) {
    precise REAL way = t * direction;
    precise REAL c = anchor + way;
    return PointModel(c, tube.x * axis, md_up(2.0 * IM_ROUNDING * (abs(way) + abs(c))));
}

REAL2 value_at(ProofRay ray, REAL t) {
    REAL3 a = ray.anchor, d = ray.direction;
    return md_range(field_model(coordinate_at(a.x, d.x, t, REAL3(1.0, 0.0, 0.0)),
                                coordinate_at(a.y, d.y, t, REAL3(0.0, 1.0, 0.0)),
                                coordinate_at(a.z, d.z, t, REAL3(0.0, 0.0, 1.0))));
}
