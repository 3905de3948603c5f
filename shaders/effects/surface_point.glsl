// The end of a ray, kept for the rays that start there.

struct SurfacePoint {
    vec3 position;    // formula coordinates
    float offset;     // along the normal: from there the surface is on the other side
    vec3 normal;      // unit length, towards the origin of the ray
    int verdict;      // of the ray; a miss may still have met the ground
    bool inside;      // seen from where F < 0
    bool on_ground;
    float steepness;  // |grad F|
    float t;          // on its ray
    float pixel;      // width of the pixel that sees it
#ifdef SECTIONS
    int cap;          // the section whose cap it is on, or -1
#endif
};

SurfacePoint point_at(vec3 position, float offset, vec3 normal, int verdict, bool inside,
                      bool on_ground, float steepness, float t, float pixel) {
#ifdef SECTIONS
    return SurfacePoint(position, offset, normal, verdict, inside, on_ground, steepness, t, pixel, -1);
#else
    return SurfacePoint(position, offset, normal, verdict, inside, on_ground, steepness, t, pixel);
#endif
}

bool is_on_surface(SurfacePoint p) {
    return on_surface(p.verdict);
}

SurfacePoint unpack_surface(vec4 a, vec4 b, vec4 c) {
    int code = int(b.w);
    SurfacePoint p = point_at(a.xyz, a.w, b.xyz, code & 7, (code & 8) != 0, (code & 16) != 0, c.x,
                              c.y, c.z);
#ifdef SECTIONS
    p.cap = int(c.w) - 1;
#endif
    return p;
}

#ifdef HITS
Hit hit_of(SurfacePoint p) {
    Hit hit = hit_at(p.position, p.normal, p.t, p.inside);
#ifdef SECTIONS
    hit.cap = p.cap;
#endif
    return hit;
}
#endif
