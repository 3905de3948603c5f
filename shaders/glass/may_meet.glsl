// The ray of a path through one surface. Needs path.glsl.
bool may_meet(Path path) {
    return goes_on(path);
}

float least_begin(Path path) {
    return path.off;
}
