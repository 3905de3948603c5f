// Work groups extend over the tile's upper and right edges.
uniform ivec2 tile_size;

void main() {
    if (all(lessThan(ivec2(pixel_centre), tile_size))) march_pixel();
}
