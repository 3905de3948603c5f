// Ends paths. Needs path.glsl, ground_ahead() and behind().

// Ends a path whose ray meets no surface: on the ground, or with the light from behind.
Path see_behind(Path path) {
    float way = ground_ahead(path.position, path.direction);
    if (way > 0.0) {
        path.position += way * path.direction;
        path.state = PATH_ON_GROUND;
        return path;
    }
    path.light += path.weight * behind(path.direction);
    path.state = PATH_ENDED;
    return path;
}

// Ends a path in the same way if it may have no further ray, or its next would hardly be seen.
Path unless_faint(Path path, int rays_left) {
    float weight = max(max(path.weight.r, path.weight.g), path.weight.b);
    if (rays_left > 0 && weight > 0.001) return path;
    return see_behind(path);
}
