// Copies the paths that went on back to the textures of all paths.
#ifdef FOLLOWS_PATHS
layout(location = 0) out vec4 path_0;
layout(location = 1) out vec4 path_1;
layout(location = 2) out vec4 path_2;
layout(location = 3) out vec4 path_3;
layout(location = 4) out vec4 path_4;

void main() {
    ivec2 at = ivec2(pixel_centre);
    path_0 = texelFetch(glass_texture_0, at, 0);
    path_1 = texelFetch(glass_texture_1, at, 0);
    path_2 = texelFetch(glass_texture_2, at, 0);
    path_3 = texelFetch(glass_texture_3, at, 0);
    path_4 = texelFetch(glass_texture_4, at, 0);
}
#else
void main() {
    store_path(load_path());
}
#endif
