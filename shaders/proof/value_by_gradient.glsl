// What F can be at a point of the rays: its value on the one here, and how far its gradient lets it
// be off on the others. Near nodes, where terms cancel in the gradient, the natural bound is wider
// by far.
vec2 value_at(Ray ray, float t) {
    precise vec3 p = ray_point(ray, t);
    Box all = box_around(ray, t, t);
    vec2 gx, gy, gz;
    field_gradient_interval(all.x, all.y, all.z, gx, gy, gz);
    precise float steepest = im_abs(gx).y + im_abs(gy).y + im_abs(gz).y;
    precise float off = 1.000001 * steepest * tube.x;
    return im_add(field_interval(vec2(p.x), vec2(p.y), vec2(p.z)), vec2(-off, off));
}
