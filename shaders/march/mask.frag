// Writes which rays have a way to march, as depth: 1, else 0. The draw that marches is at depth 0.5,
// and the depth test comes before its shader runs. Only this test spares a software renderer the
// shader: it goes through both sides of a branch.
void main() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    gl_FragDepth = ray.t_near <= ray.t_far ? 1.0 : 0.0;
}
