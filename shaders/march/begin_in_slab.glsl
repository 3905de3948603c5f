// The state before any sample of a ray, which a settled ray begins in the middle of the slab that holds
// its first root, and ends there.
RayState begin_in_slab(inout Ray ray, RayState before) {
    ivec2 pixel = ivec2(pixel_centre), block = pixel / BLOCK;
    vec4 slab = slab_of(block, SQUARE_BITS);
    float middle = middle_of_slab(slab, vec2(pixel - block * BLOCK), BLOCK);
    if (slab.w > 0.0) {
        ray.t_near = (middle - slab.w) * ray.to_eye;
        ray.t_far = (middle + slab.w) * ray.to_eye;
        before = state_at(middle * ray.to_eye);
        before.phase = PHASE_NEWTON;
    }
    return before;
}
