// Proofs in doubles use the exact ray of the same numbers, which float32 rounded to the marched
// one.
struct ProofRay {
    dvec3 anchor, direction;
    double t_near, t_far; // of the marched ray
    double to_eye;
};

ProofRay proof_ray(Ray marched) {
    dvec2 at = (dvec2(pixel_centre) + dvec2(picture.zw)) * dvec2(picture.xy) - 1.0;
    dvec3 across = at.x * dvec3(ray_right.xyz) + at.y * dvec3(ray_up.xyz);
    dvec3 from_eye = dvec3(ray_axis.xyz) + double(ray_axis.w) * across;
    dvec3 squares = from_eye * from_eye;
    double distance_to_eye = sqrt(squares.x + squares.y + squares.z);
    return ProofRay(dvec3(ray_origin.xyz) + across, from_eye / distance_to_eye,
                    double(marched.t_near), double(marched.t_far), distance_to_eye);
}

dvec3 ray_point(ProofRay ray, double t) {
    return ray.anchor + t * ray.direction;
}

// Rounds x to a float that is not farther from 0.
float toward_zero(double x) {
    return 0.9999998 * float(clamp(x, -double(3.4e38), double(3.4e38)));
}

// The t at which a piece is sampled: its beginning; or the root, where floats were too coarse.
const bool SAMPLES_ROOTS = true;
double sampled_at(ProofState s, double low) { return s.at_root ? double(s.settled) : low; }
double uncertain_at_root(ProofState s, dvec2 sampled) { return max(-sampled.x, sampled.y); }
