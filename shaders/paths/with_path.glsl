// Adds the light of a pixel's path to that of what the eye's ray met. Needs path.glsl and
// surfaces/seen.glsl.
vec3 with_path(vec3 own) {
    Path path = load_path();
    vec3 light = path.own * own + path.light;
    bool ended_on_something = path.state == PATH_ON_GROUND || path.state == PATH_ON_SURFACE;
    return ended_on_something ? light + path.weight * seen_in_mirror().rgb : light;
}
