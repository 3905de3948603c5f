// A point on the surface.
struct Hit {
    vec3 position; // formula coordinates
    vec3 normal;   // unit length, towards the viewer
    float t;
    bool inside;   // seen from where F < 0
#ifdef SECTIONS
    int cap;       // the section whose cap it is on, or -1
#endif
};

Hit hit_at(vec3 position, vec3 normal, float t, bool inside) {
#ifdef SECTIONS
    return Hit(position, normal, t, inside, -1);
#else
    return Hit(position, normal, t, inside);
#endif
}
