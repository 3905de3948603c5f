// Begins the paths of the pixels, where the eye's ray meets glass or ends inside it.
uniform int rays_left;

void main() {
    Ray ray = pixel_ray();
    SurfacePoint p = load_surface();
    bool hit = is_on_surface(p);
    Path path = Path(vec3(0.0), PATH_ENDED, ray.direction, 0, 0.0, vec3(1.0), vec3(0.0));
    float end = hit || p.on_ground ? min(p.t, ray.t_far) : ray.t_far;
    bool in_bounds = ray.t_near < end;
    vec3 begin = ray_point(ray, ray.t_near);
    bool in_glass = hit ? p.inside : in_bounds && field(begin) < 0.0;
#ifdef SECTIONS
    if (!hit && sections_value(begin) > 0.0) in_glass = false;
#endif
    float way = in_glass ? end - ray.t_near : 0.0;
    path.weight = absorbed(way);
    if (hit) path = unless_faint(through(path, p, glass.y, absorbed(way), transmission()), rays_left);
    store_path(path);
}
