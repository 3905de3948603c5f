// Opens the gate for rays with something to prove. What stays closed are misses without a way to go:
// beams proved it, or the ray is off the bounds by more than rounding can be.
void main() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    bool ended = load_ending(ivec2(pixel_centre)).miss && !(ray.t_near <= ray.t_far);
    gl_FragDepth = ended ? 0.0 : 1.0;
}
