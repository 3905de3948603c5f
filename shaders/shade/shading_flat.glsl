// The block of shading.glsl for plain pictures with one light. The part that every fragment needs
// comes through fullscreen.vert.
flat in vec4 material_color;
flat in vec4 background;
flat in vec4 light_direction[1];
flat in vec4 light_color[1];

layout(std140) uniform Shading {
    vec4 flat_part[4];
    mat4 to_world;
    vec4 depth;
};
