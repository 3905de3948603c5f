// Rays march no farther than to what is seen of the surfaces before this one. Needs shared_way() and
// way_before().
void enter_beam(inout Ray ray) {
    enter_own_beam(ray);
    ray.t_far = min(ray.t_far, (way_before() - surface_way.y * ray.to_eye) / surface_way.x);
}
