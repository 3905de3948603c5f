// What colours of a plain picture with one light need: the block of shading.glsl, of which every
// fragment's part comes by way of fullscreen.vert.
flat in vec4 material_color;
flat in vec4 background;
flat in vec4 light_direction[1];
flat in vec4 light_color[1];

layout(std140) uniform Shading {
    vec4 flat_part[4];
    mat4 to_world;
    vec4 depth;
};
