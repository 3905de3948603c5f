// Passes where a path goes on: a query on this draw tells whether its next ray is needed.
layout(location = 0) out vec4 unused;

void main() {
    if (!goes_on(load_path())) discard;
    unused = vec4(1.0);
}
