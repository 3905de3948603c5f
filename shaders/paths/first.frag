// Begins the paths of the pixels of begins.frag. Rays that begin in glass, or enter it at bounds, are
// followed anew from there.
uniform int rays_left;
uniform sampler2D surface_texture_4; // see bounds.glsl
uniform vec4 surface_way;            // see surfaces/way.glsl

void main() {
    ivec2 at = ivec2(pixel_centre);
    vec4 end = IM_TEXEL(surface_texture_3, at), begin = IM_TEXEL(surface_texture_4, at);
    Ray ray = pixel_ray();
    SurfacePoint p = load_surface();
    Path path = Path(vec3(0.0), PATH_ENDED, ray.direction, 0, 0.0, vec3(1.0), vec3(0.0), rays_left, 0,
                     NO_MATTER, vec3(0.0), false, -1, 1.0);
    bool is_known = is_on_surface(p) || p.verdict == VERDICT_MISS;
    if (is_known && begin.y > 0.0 && begin.x < end.x) {
        path.position = ray_point(ray, (begin.x - surface_way.y * ray.to_eye) / surface_way.x);
        path.matter = int(begin.y) - 1;
        path.state = PATH_IN_GLASS;
        path.own = 0.0;
    } else if (is_on_surface(p)) {
        path = meet(path, p, 0.0, true);
    }
    store_path(with_ground(path));
}
