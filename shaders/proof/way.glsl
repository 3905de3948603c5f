// The part of a ray that its proof covers: what beams left of it and, rounding included, the proof
// of its block.
uniform sampler2D block_texture;

vec4 load_block() {
    return IM_TEXEL(block_texture, ivec2(pixel_centre) / PROVED_BLOCK);
}

// The tau up to which the block's proof settled the ray, see block.frag.
float settled_by_block(vec4 block) {
    vec2 place = vec2(ivec2(pixel_centre) % PROVED_BLOCK) * (2.0 / float(PROVED_BLOCK - 1)) - 1.0;
    return block.x + dot(block.yz, place);
}

Ray marched_ray() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    return ray;
}

Ray ray_to_prove(Ray ray) {
#ifdef LISTS
    choose_list_of_proof(ray, load_ending(ivec2(pixel_centre)));
#endif
    ray.t_near = max(ray.t_near, settled_by_block(load_block()) * ray.to_eye) - tube.z;
    ray.t_far += tube.z;
    return ray;
}
