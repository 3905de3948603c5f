// The path of a pixel's light through glass, traced from the eye: the light found so far, and the
// ray that looks for the rest.
const int PATH_ENDED = 0;
const int PATH_IN_GLASS = 1;  // its ray goes on within F < 0
const int PATH_OUTSIDE = 2;   // its ray goes on outside
const int PATH_ON_GROUND = 3; // it ended on the ground
const int PATH_LOST = 5;      // it ended undecided

struct Path {
    vec3 position;  // where its ray begins, or where it ended on the ground
    int state;
    vec3 direction; // unit length
    int evaluations; // so far
    float off;      // distance along its ray from which that is on the right side of the surface
    vec3 weight;    // of what its ray sees, in the pixel's colour
    vec3 light;     // in the pixel's colour so far
};

uniform sampler2D glass_texture_0;
uniform sampler2D glass_texture_1;
uniform sampler2D glass_texture_2;
uniform sampler2D glass_texture_3;

Path load_path() {
    ivec2 at = ivec2(pixel_centre);
    vec4 a = IM_TEXEL(glass_texture_0, at), b = IM_TEXEL(glass_texture_1, at);
    vec4 c = IM_TEXEL(glass_texture_2, at), d = IM_TEXEL(glass_texture_3, at);
    return Path(a.xyz, int(a.w), b.xyz, int(b.w), c.w, c.xyz, d.xyz);
}

bool goes_on(Path path) {
    return path.state == PATH_IN_GLASS || path.state == PATH_OUTSIDE;
}

#ifdef STORES_PATHS
// Stores a path.
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
#endif
