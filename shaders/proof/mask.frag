// Opens the depth gate for rays with something to prove. It stays closed for misses without a part
// to march: beams proved them, or the ray misses the bounds by more than rounding.
void main() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    bool ended = load_ending(ivec2(pixel_centre)).miss && !(ray.t_near <= ray.t_far);
    gl_FragDepth = ended ? 0.0 : 1.0;
}
