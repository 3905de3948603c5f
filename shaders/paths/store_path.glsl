// Stores a path in the coordinates of this surface. Needs path.glsl.
layout(location = 0) out vec4 path_0;
layout(location = 1) out vec4 path_1;
layout(location = 2) out vec4 path_2;
layout(location = 3) out vec4 path_3;
layout(location = 4) out vec4 path_4;

void store_path(Path path) {
    int code = path.state + (path.inside ? 8 : 0) + (SURFACE << 4) + ((path.matter + 1) << 7) +
               ((path.cap + 1) << 11);
    path_0 = vec4(path.position, float(code));
    path_1 = vec4(path.direction, float(path.evaluations));
    path_2 = vec4(path.weight, path.off);
    path_3 = vec4(path.light, float(path.rays_left + (path.crossings << 5)));
    path_4 = vec4(path.normal, path.own);
}
