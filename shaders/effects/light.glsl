// The light of one source at a point.
struct LightRay {
    vec3 direction; // to the light, unit length
    float reach;    // its distance
    vec3 strength;
};
