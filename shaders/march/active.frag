// Keeps pixels whose ray still marches. A query on this draw tells whether another pass is needed.
layout(location = 0) out vec4 unused;

void main() {
    if (load_state().phase == PHASE_DONE) discard;
    unused = vec4(1.0);
}
