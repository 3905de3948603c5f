#version 300 es
// Passes where a ray did not end within one draw: VERDICT_UNFINISHED of shaders/shade/record.glsl.
precision highp float;
precision highp usampler2D;
uniform usampler2D record;

layout(location = 0) out vec4 unused;

void main() {
    if ((texelFetch(record, ivec2(gl_FragCoord.xy), 0).r & 7u) != 7u) discard;
    unused = vec4(1.0);
}
