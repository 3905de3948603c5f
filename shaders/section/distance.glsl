// Distance from a point to the surface of the remaining solid, on either side of it, for occlusion.
// `of_matter`: distance to the surface of F. Needs sections.glsl.
float distance_to_rest(vec3 place, bool inside, float of_matter) {
    float cut = sections_value(place);
    return inside ? min(of_matter, -cut) : max(of_matter, cut);
}

// offset_from() of end_of_ray.glsl for a cap.
float offset_from_cap(vec3 position, vec3 normal, int cap, bool inside, float pixel) {
    float offset = 0.05 * pixel;
    for (int k = 0; k < 8; ++k) {
        float value = section_value(cap, position + offset * normal);
        if (inside ? value < 0.0 : value > 0.0) break;
        offset *= 2.0;
    }
    return offset;
}
