// The path of a pixel's light among several surfaces, traced from the eye: the light found so far, and
// the ray that looks for the rest. Kept in the coordinates of the surface where its ray began, and
// loaded in those of this one. SURFACES is their number, SURFACE this one's.
const int PATH_ENDED = 0;
const int PATH_IN_GLASS = 1;   // its ray goes on,
const int PATH_OUTSIDE = 2;    // as well
const int PATH_ON_GROUND = 3;  // it ended there,
const int PATH_ON_SURFACE = 4; // or on a surface that it does not go on from: the light is that of seen.frag
const int PATH_LOST = 5;       // or undecided
const int NO_MATTER = -1;      // what is around

struct Path {
    vec3 position;  // where its ray begins, or where it ended
    int state;
    vec3 direction; // unit length
    int evaluations; // so far
    float off;      // distance along its ray from which that is on the right side of the surface; of an
                    // end, along the normal
    vec3 weight;    // of what its ray sees, in the pixel's colour
    vec3 light;     // in the pixel's colour so far
    int rays_left;
    int crossings;  // of bounds where matter ends without a surface
    int matter;     // the surface in whose glass its ray goes on
    vec3 normal;    // of its end, towards its ray
    bool inside;    // of its end: seen from where F < 0
    int cap;        // of its end
    float own;      // weight of the colour of what the eye's ray met, in the pixel's
};

uniform sampler2D glass_texture_0;
uniform sampler2D glass_texture_1;
uniform sampler2D glass_texture_2;
uniform sampler2D glass_texture_3;
uniform sampler2D glass_texture_4;
uniform vec4 path_moves[3 * SURFACES]; // as surface_moves of effects/load_surface.glsl

int owner_of_path() {
    return (int(IM_TEXEL(glass_texture_0, ivec2(pixel_centre)).w) >> 4) & 7;
}

// In the coordinates in which it is kept: those of owner_of_path().
Path load_path_as_it_is() {
    ivec2 at = ivec2(pixel_centre);
    vec4 a = IM_TEXEL(glass_texture_0, at), b = IM_TEXEL(glass_texture_1, at);
    vec4 c = IM_TEXEL(glass_texture_2, at), d = IM_TEXEL(glass_texture_3, at);
    vec4 e = IM_TEXEL(glass_texture_4, at);
    int code = int(a.w), rays = int(d.w);
    return Path(a.xyz, code & 7, b.xyz, int(b.w), c.w, c.xyz, d.xyz, rays & 31, rays >> 5,
                ((code >> 7) & 15) - 1, e.xyz, (code & 8) != 0, ((code >> 11) & 15) - 1, e.w);
}

Path load_path() {
    Path path = load_path_as_it_is();
    int k = 3 * owner_of_path();
    vec4 x = path_moves[k], y = path_moves[k + 1], z = path_moves[k + 2];
    float scale = length(x.xyz);
    vec4 at = vec4(path.position, 1.0);
    vec3 along = path.direction, up = path.normal;
    path.position = vec3(dot(x, at), dot(y, at), dot(z, at));
    path.direction = vec3(dot(x.xyz, along), dot(y.xyz, along), dot(z.xyz, along)) / scale;
    path.normal = vec3(dot(x.xyz, up), dot(y.xyz, up), dot(z.xyz, up)) / scale;
    path.off *= scale;
    return path;
}

bool goes_on(Path path) {
    return path.state == PATH_IN_GLASS || path.state == PATH_OUTSIDE;
}

#ifdef STORES_PATHS
// Stores a path in the coordinates of this surface.
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
#endif
