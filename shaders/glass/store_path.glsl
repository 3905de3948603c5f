// Stores a path. Needs path.glsl.
layout(location = 0) out vec4 path_0;
layout(location = 1) out vec4 path_1;
layout(location = 2) out vec4 path_2;
layout(location = 3) out vec4 path_3;

void store_path(Path path) {
    path_0 = vec4(path.position, float(path.state));
    path_1 = vec4(path.direction, float(path.evaluations));
    path_2 = vec4(path.weight, path.off);
    path_3 = vec4(path.light, 0.0);
}
