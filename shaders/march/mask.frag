// Which rays have a way to march, as depth: 1, or 0 of the others. The draw that marches is at 0.5
// and is tested against it before its shader runs, which software renderers skip by nothing else:
// they go through both sides of a branch.
void main() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    gl_FragDepth = ray.t_near <= ray.t_far ? 1.0 : 0.0;
}
