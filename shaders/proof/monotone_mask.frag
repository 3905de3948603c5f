// Opens the depth gate for rays of blocks in which F is proved monotone around the roots, and closes it
// for all others.
uniform sampler2D block_texture;

void main() {
    float slope = IM_TEXEL(block_texture, ivec2(pixel_centre) / PROVED_BLOCK).w;
    gl_FragDepth = slope > 0.0 ? 1.0 : 0.0;
}
