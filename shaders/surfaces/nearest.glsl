// Keeps the nearest of the ends on all surfaces. Needs way.glsl, and store_surface.glsl or
// keep_channels().
#if SURFACE > 0

// The distance by which a surface has to be nearer than those before it in the file to be seen, in
// lengths of the first one's formula: roots are not known better. Where surfaces coincide, the
// earlier is seen.
float least_nearer(vec3 position) {
    vec3 eye = ray_origin.xyz - ray_axis.xyz;
    float along = dot(position - eye, ray_axis.xyz) / dot(ray_axis.xyz, ray_axis.xyz);
    float pixel = picture.y * length(ray_up.xyz);
    if (ray_axis.w > 0.0) pixel *= max(abs(along), 1.0e-6);
    return surface_way.x * max(0.0625 * pixel, 4.0 * cubics.z);
}
#endif

#ifdef DRAWS_AT_ONCE
// Keeps what the surfaces before this one drew where this one is not nearer, and adds up the
// evaluations of all.
#if SURFACE == 0
void keep_nearest(Ray ray, RayState s) {}
#else
uniform sampler2D before_texture_0;
uniform usampler2D before_texture_1;

void keep_nearest(Ray ray, RayState s) {
    ivec2 at = ivec2(pixel_centre);
    float others = way_before();
    uint before = texelFetch(before_texture_1, at, 0).x;
    int verdict = int(record & 7u), verdict_before = int(before & 7u);
    bool is_nearer = way < NO_END && way < others - least_nearer(ray_point(ray, s.low));
    if (!is_nearer) {
        color = IM_TEXEL(before_texture_0, at);
        way = others;
        keep_channels(at);
    }
    bool is_unfinished = verdict == VERDICT_UNFINISHED || verdict_before == VERDICT_UNFINISHED;
    verdict = is_unfinished ? VERDICT_UNFINISHED : is_nearer ? verdict : verdict_before;
    record = packed_record(verdict, s.evaluations + int(before >> 3));
}
#endif
#else
layout(location = 3) out vec4 surface_3; // shared way, evaluations so far, index of the surface

// Rays that gave up end there, too: what is before that counts, what is behind it doesn't.
float way_to_end(Ray ray, SurfacePoint p) {
    bool ends = p.verdict != VERDICT_MISS || p.on_ground;
    return ends ? shared_way(ray, p.t) : NO_END;
}

void store_end(SurfacePoint p, float way, float evaluations) {
    store_surface(p, 0);
    surface_3 = vec4(way, evaluations, float(SURFACE), 0.0);
}

#if SURFACE == 0
void store_nearest(Ray ray, SurfacePoint p, int evaluations) {
    store_end(p, way_to_end(ray, p), float(evaluations));
}
#else
// A surface that comes after others in the file is the nearer one only by more than roots are known to.
void store_nearest(Ray ray, SurfacePoint p, int evaluations) {
    vec4 others = before(3);
    float way = way_to_end(ray, p);
    float all = others.y + float(evaluations);
    if (way < NO_END && way < others.x - least_nearer(p.position)) {
        store_end(p, way, all);
    } else {
        surface_0 = before(0);
        surface_1 = before(1);
        surface_2 = before(2);
        surface_3 = vec4(others.x, all, others.zw);
    }
}
#endif
#endif
