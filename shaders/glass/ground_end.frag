// Stores ground seen through glass as ends of rays, where shadow rays to the lights start.
void main() {
    Path path = load_path();
    bool on_ground = path.state == PATH_ON_GROUND;
    float pixel = load_surface().pixel;
    store_surface(point_at(path.position, 0.05 * pixel, ground_normal(path.direction), VERDICT_MISS,
                           false, on_ground, 1.0, 0.0, pixel), 0);
}
