// The uniforms of colours for LIGHTS lights: shading_block() of src/render/uniform_blocks.h.
#ifdef FLAT_SHADING
// Of plain pictures with one light. The part that every fragment needs comes through fullscreen.vert.
flat in vec4 material_color;
flat in vec4 background;
flat in vec4 light_direction[1];
flat in vec4 light_color[1];

layout(std140) uniform Shading {
    vec4 flat_part[4];
    mat4 to_world;
    vec4 depth;
};
#else
layout(std140) uniform Shading {
    vec4 material_color;
    vec4 background; // with its coverage
    vec4 light_direction[LIGHTS]; // to the light, unit length, formula coordinates
    vec4 light_color[LIGHTS];
    mat4 to_world;   // formula coordinates to world; its columns are scaled axes
    vec4 depth;      // depth of the plane t = 0, and depth per t along (xyz . direction)
};
#endif
