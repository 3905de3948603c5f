#version 300 es
// Adds a tile's picture to the sum of those before it: a frame is the mean of several.
precision highp float;
precision highp sampler2D;
uniform sampler2D result; // of the tile
uniform sampler2D sum;
uniform ivec2 tile_origin;

layout(location = 0) out vec4 color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    color = texelFetch(sum, at, 0) + texelFetch(result, at - tile_origin, 0);
}
