// A point on the surface, and the record of a pixel's rays.
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

// Packs the record: src/render/record.h. VERDICT_UNFINISHED is no Verdict. If a
// pixel has further rays, three more words are evaluations for shadows, evaluations of mirrored and
// refracted rays, and how many of both stay undecided, with the evaluations for occlusion above these.
const int VERDICT_UNFINISHED = 7;

uint packed_record(int verdict, int evaluations) {
    return uint(verdict) | uint(evaluations) << 3;
}

uint packed_further(float undecided_shadows, int undecided_paths, int for_occlusion) {
    return min(uint(undecided_shadows), 255u) | uint(undecided_paths) << 8 | uint(for_occlusion) << 16;
}
