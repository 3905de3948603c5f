// Shades the rays of a finished march.
void main() {
    shade_ray(pixel_ray(), load_state());
}
