// Passes where a proof goes on: a query on this draw tells whether another pass is needed.
uniform sampler2D proof_texture_0;
layout(location = 0) out vec4 unused;

void main() {
    if (texelFetch(proof_texture_0, ivec2(pixel_centre), 0).x >= 0.0) discard;
    unused = vec4(1.0);
}
