// Opens the depth gate for blocks whose beams left a part to march. No ray of any other block marches,
// so that all of them miss, as the beam proved.
layout(location = 0) out vec4 block_proof; // as in block.frag

void main() {
    ivec2 block = ivec2(pixel_centre);
    vec4 part = part_of_beam(beam_texel(block * BLOCK / PARENT_BLOCK, PARENT_SQUARE_BITS));
    block_proof = vec4(0.0, 0.0, 0.0, BLOCK_MISSES);
    gl_FragDepth = part.x < part.y ? 1.0 : 0.0;
}
