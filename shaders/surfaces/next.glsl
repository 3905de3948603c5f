// A surface that comes after others in the file is the nearer one only by more than roots are known to.
// Needs nearest.glsl, least_nearer() and before().
void store_nearest(Ray ray, SurfacePoint p, int evaluations) {
    vec4 others = before(3);
    float way = way_to_end(ray, p);
    float all = others.y + float(evaluations);
    if (way < NO_END && way < others.x - least_nearer(p.position)) {
        store_end(p, way, all);
    } else {
        surface_0 = before(0);
        surface_1 = before(1);
        surface_2 = before(2);
        surface_3 = vec4(others.x, all, others.zw);
    }
}
