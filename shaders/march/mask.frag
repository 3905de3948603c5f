#if defined(COUNTS_RAYS)
// Keeps pixels whose ray still marches. A query on this draw tells whether another pass is needed.
layout(location = 0) out vec4 unused;

void main() {
    if (load_state().phase == PHASE_DONE) discard;
    unused = vec4(1.0);
}
#elif defined(MASKS_BLOCKS)
// Writes depth 1 for the pixels of blocks whose beam left a part to march, otherwise 0, as below
// ray by ray: a ray of such a block that misses the bounds is found to miss by the shader itself.
uniform sampler2D beam_texture;

void main() {
    ivec2 at = beam_texel(ivec2(pixel_centre) / BLOCK, SQUARE_BITS);
    vec4 part = IM_TEXEL(beam_texture, at);
    gl_FragDepth = part.x < part.y ? 1.0 : 0.0;
}
#else
// Writes depth 1 for rays with a part to march, otherwise 0. The draw that marches is at depth 0.5,
// and the depth test precedes its shader. Only this test saves a software renderer from running the
// shader, since it executes both sides of a branch.
void main() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    gl_FragDepth = ray.t_near <= ray.t_far ? 1.0 : 0.0;
}
#endif
