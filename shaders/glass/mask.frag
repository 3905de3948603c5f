// Writes as depth whether a path goes on: see march/mask.frag.
void main() {
    gl_FragDepth = goes_on(load_path()) ? 1.0 : 0.0;
}
