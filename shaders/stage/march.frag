// The viewport is the tile.
void main() {
    march_pixel();
}
