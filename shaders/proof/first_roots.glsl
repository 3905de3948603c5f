// Whether the roots of a block's rays, where all hit, are known to be the first ones: each lies in the slab
// that holds the first root of its ray, and no other one. Roots may be off by `around`, in tau.
bool are_first_roots(ivec2 block, Ends ends, float around) {
    ivec2 larger = block * BLOCK / PARENT_BLOCK, corner = block * BLOCK - larger * PARENT_BLOCK;
    vec4 slab = slab_of(larger, PARENT_SQUARE_BITS);
    float farthest = 0.0;
    for (int k = 0; k < RAYS; ++k) {
        vec2 pixel = vec2(corner + ivec2(k % BLOCK, k / BLOCK));
        farthest = max(farthest, abs(ends.taus[k] - middle_of_slab(slab, pixel, PARENT_BLOCK)));
    }
    return farthest < slab.w - around;
}
