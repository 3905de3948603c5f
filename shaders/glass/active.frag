// Keeps pixels whose path goes on. A query on this draw tells whether another ray is needed.
layout(location = 0) out vec4 unused;

void main() {
    if (!goes_on(load_path())) discard;
    unused = vec4(1.0);
}
