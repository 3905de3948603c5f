// What comes from one light to a place.
struct LightRay {
    vec3 direction; // to the light, unit length
    float reach;    // its distance
    vec3 strength;
};
