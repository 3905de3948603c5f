// What the ray of a path may meet of this surface: in matter whose rank is less, glass is not there. Needs
// path.glsl and matter.glsl.
bool may_meet(Path path) {
#ifdef GLASS
    return goes_on(path) && (path.matter == SURFACE || rank_of(SURFACE) < rank_of(path.matter));
#else
    return goes_on(path);
#endif
}

// The place on the path's ray from which on it may meet this surface.
float least_begin(Path path) {
#ifdef GLASS
    return path.off;
#else
    // What lies on the glass that the ray has come through, or nearer to it than rays begin.
    return -2.0 * path.off;
#endif
}
