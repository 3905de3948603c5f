#if defined(VALUE_BY_MODEL)
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
#elif defined(VALUE_BY_GRADIENT)
// Bounds F at a point of the rays: its value on this ray, widened by its gradient for the others.
// Near nodes, where terms cancel in the gradient, the natural bound is far wider.
REAL2 value_at(ProofRay ray, REAL t) {
    precise REAL3 p = ray_point(ray, t);
    Box all = box_around(ray, t, t);
    REAL2 gx, gy, gz;
    field_gradient_interval(all.x, all.y, all.z, gx, gy, gz);
    precise REAL steepest = im_abs(gx).y + im_abs(gy).y + im_abs(gz).y;
    precise REAL off = 1.000001 * steepest * tube.x;
    return im_add(field_interval(REAL2(p.x), REAL2(p.y), REAL2(p.z)), REAL2(-off, off));
}
#else
// Bounds F at a point of the rays by its natural bound over all of them.
REAL2 value_at(ProofRay ray, REAL t) {
    Box p = box_around(ray, t, t);
    return field_interval(p.x, p.y, p.z);
}
#endif
