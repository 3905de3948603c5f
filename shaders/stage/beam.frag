// The viewport is a square of blocks: march/beam_place.glsl.
void main() {
    follow_beam(beam_block(ivec2(pixel_centre), SQUARE_BITS));
}
