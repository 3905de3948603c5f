#version 300 es
// Passes where a ray did not end within one draw: VERDICT_UNFINISHED of shaders/shade/hit.glsl.
precision highp float;
precision highp usampler2D;
uniform usampler2D record;

layout(location = 0) out vec4 unused;

void main() {
    // Software renderers take twice as long to fetch a texel as to sample one.
    vec2 at = gl_FragCoord.xy / vec2(textureSize(record, 0));
    if ((textureLod(record, at, 0.0).r & 7u) != 7u) discard;
    unused = vec4(1.0);
}
