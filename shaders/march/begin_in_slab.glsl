// The state before any sample of a ray. A settled ray begins in the middle of the slab that holds its first
// root, and is restricted to that.
RayState begin_in_slab(inout Ray ray, RayState s) {
    ivec2 pixel = ivec2(pixel_centre), block = pixel / BLOCK;
    vec4 slab = slab_of(block, SQUARE_BITS);
    if (slab.w != 0.0) {
        float middle = middle_of_slab(slab, vec2(pixel - block * BLOCK), BLOCK);
        precise float near = (middle - slab.w) * ray.to_eye, far = (middle + slab.w) * ray.to_eye;
        precise float guess = middle * ray.to_eye;
        ray.t_near = near;
        ray.t_far = far;
        s = state_at(near);
        s.f_low.x = far;
        s.high = guess;
        s.phase = PHASE_NEWTON;
    }
    return s;
}
