// Writes as depth whether a path ended on the ground or on a surface that it does not go on from. Needs
// path.glsl; see march/mask.frag.
void main() {
    int state = load_path().state;
    gl_FragDepth = state == PATH_ON_GROUND || state == PATH_ON_SURFACE ? 1.0 : 0.0;
}
