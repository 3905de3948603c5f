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
    vec4 a = texelFetch(glass_texture_0, at, 0), b = texelFetch(glass_texture_1, at, 0);
    vec4 c = texelFetch(glass_texture_2, at, 0), d = texelFetch(glass_texture_3, at, 0);
    return Path(a.xyz, int(a.w), b.xyz, int(b.w), c.w, c.xyz, d.xyz);
}

bool goes_on(Path path) {
    return path.state == PATH_IN_GLASS || path.state == PATH_OUTSIDE;
}
