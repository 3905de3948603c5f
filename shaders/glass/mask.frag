#if defined(COUNTS_RAYS)
// Keeps pixels whose path goes on. A query on this draw tells whether another ray is needed.
layout(location = 0) out vec4 unused;

void main() {
    if (!goes_on(load_path())) discard;
    unused = vec4(1.0);
}
#elif defined(ENDED_PATHS)
// Writes as depth whether a path ended on the ground or on a surface that it does not go on from.: see
// march/mask.frag.
void main() {
    int state = load_path().state;
    gl_FragDepth = state == PATH_ON_GROUND || state == PATH_ON_SURFACE ? 1.0 : 0.0;
}
#else
// Writes as depth whether a path goes on: see march/mask.frag.
void main() {
    gl_FragDepth = goes_on(load_path()) ? 1.0 : 0.0;
}
#endif
