#ifdef BEAM_BOXES
#ifdef COMPUTE
// Work groups extend over the upper and right edges of the blocks.
uniform ivec4 blocks; // the first one's place, and how many there are

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, blocks.zw))) return;
    ivec2 block = blocks.xy + at;
    follow_beam(block);
    store_results(beam_texel(block, SQUARE_BITS));
}
#else
// The viewport is a square of blocks: march/beam_place.glsl.
void main() {
    follow_beam(beam_block(ivec2(pixel_centre), SQUARE_BITS));
}
#endif
#else
#ifdef COMPUTE
// Work groups extend over the tile's upper and right edges.
uniform ivec2 tile_size;

void main() {
    if (all(lessThan(ivec2(pixel_centre), tile_size))) march_pixel();
}
#else
// The viewport is the tile.
void main() {
    march_pixel();
}
#endif
#endif
