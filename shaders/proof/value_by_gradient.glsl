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
