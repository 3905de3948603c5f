// A place on the surface.
struct Hit {
    vec3 position; // formula coordinates
    vec3 normal;   // unit length, towards the viewer
    float t;
    bool inside;   // seen from where F < 0
};
