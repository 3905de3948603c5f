// What paths see beside the surfaces. Needs path.glsl, ground.glsl and effects/sky.glsl.

// Far away, as mirrors show it: the map also where another background is seen.
vec3 around(vec3 direction) {
#ifdef ENVIRONMENT
    return environment(direction);
#else
    return sky(direction).rgb;
#endif
}

// Far away, behind glass.
vec3 behind(vec3 direction) {
#ifdef TRANSPARENT
    return around(direction);
#else
    return sky(direction).rgb;
#endif
}

vec3 seen_around(vec3 position, vec3 direction) {
#ifdef GROUND
    float way = ground_ahead(position, direction);
    if (way > 0.0) return ground_light(position + way * direction, ground_normal(direction));
#endif
    return around(direction);
}

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
