// Returns the part of a ray inside the bounds, a sphere; (1, 0) if it is empty.
vec2 clip_to_bounds(vec3 anchor, vec3 direction) {
    vec3 from_centre = anchor - bounds_min.xyz;
    float middle = -dot(from_centre, direction);
    // Foot of the perpendicular: its length keeps its digits where b^2 - 4ac cancels.
    vec3 foot = from_centre + middle * direction;
    float square = bounds_min.w * bounds_min.w - dot(foot, foot);
    float half_chord = sqrt(max(square, 0.0));
    return square < 0.0 ? vec2(1.0, 0.0) : vec2(middle - half_chord, middle + half_chord);
}
