// Writes depth 1 for rays with a part to march, otherwise 0. The draw that marches is at depth 0.5,
// and the depth test precedes its shader. Only this test saves a software renderer from running the
// shader, since it executes both sides of a branch.
void main() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    gl_FragDepth = ray.t_near <= ray.t_far ? 1.0 : 0.0;
}
