// One turn of a method that samples points of the ray: next_sample() chooses the point, advance()
// continues from there.
RayState turn(RayState s, Ray ray) {
    float t = next_sample(s);
#ifdef LISTS
    choose_list(t);
#endif
    vec2 f = sample_field(ray_point(ray, t), sample_direction(s, ray));
    return advance(s, ray, t, f);
}
