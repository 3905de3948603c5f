// Copies the paths that went on back to the textures of all paths.
#ifdef FOLLOWS_PATHS
layout(location = 0) out vec4 path_0;
layout(location = 1) out vec4 path_1;
layout(location = 2) out vec4 path_2;
layout(location = 3) out vec4 path_3;
layout(location = 4) out vec4 path_4;

void main() {
    ivec2 at = ivec2(pixel_centre);
    path_0 = IM_TEXEL(glass_texture_0, at);
    path_1 = IM_TEXEL(glass_texture_1, at);
    path_2 = IM_TEXEL(glass_texture_2, at);
    path_3 = IM_TEXEL(glass_texture_3, at);
    path_4 = IM_TEXEL(glass_texture_4, at);
}
#else
void main() {
    store_path(load_path());
}
#endif
