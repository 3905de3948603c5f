// Keeps what shadow rays and seen.frag ask of an end on the ground. Needs ground_normal().
Path with_ground(Path path) {
    if (path.state != PATH_ON_GROUND) return path;
    path.normal = ground_normal(path.direction);
    path.off = 0.05 * footprint_at(path.position);
    path.inside = false;
    path.cap = -1;
    return path;
}
