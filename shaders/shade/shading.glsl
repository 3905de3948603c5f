// The uniforms of colours for LIGHTS lights: shading_block() of src/render/uniform_blocks.h.
layout(std140) uniform Shading {
    vec4 material_color;
    vec4 background; // with its coverage
    vec4 light_direction[LIGHTS]; // to the light, unit length, formula coordinates
    vec4 light_color[LIGHTS];
    mat4 to_world;   // formula coordinates to world; its columns are scaled axes
    vec4 depth;      // depth of the plane t = 0, and depth per t along (xyz . direction)
};
