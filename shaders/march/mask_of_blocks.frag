// Writes depth 1 for the pixels of blocks whose beam left a part to march, otherwise 0, as mask.frag
// does ray by ray: a ray of such a block that misses the bounds is found to miss by the shader itself.
uniform sampler2D beam_texture;

void main() {
    ivec2 at = beam_texel(ivec2(pixel_centre) / BLOCK, SQUARE_BITS);
    vec4 part = IM_TEXEL(beam_texture, at);
    gl_FragDepth = part.x < part.y ? 1.0 : 0.0;
}
