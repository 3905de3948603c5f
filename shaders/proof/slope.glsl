// F and its slope along the rays.
vec4 bounds_over(Ray ray, Box p) {
    precise vec3 least = ray.direction - tube.y;
    precise vec3 most = ray.direction + tube.y;
    return field_along_interval(p.x, p.y, p.z, vec2(least.x, most.x), vec2(least.y, most.y),
                                vec2(least.z, most.z));
}
