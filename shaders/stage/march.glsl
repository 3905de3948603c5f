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
