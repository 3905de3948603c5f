// The distance by which a surface has to be nearer than those before it in the file to be seen, in
// lengths of the first one's formula: roots are not known better. Where surfaces coincide, the
// earlier is seen. Needs surface_way.
float least_nearer(vec3 position) {
    vec3 eye = ray_origin.xyz - ray_axis.xyz;
    float along = dot(position - eye, ray_axis.xyz) / dot(ray_axis.xyz, ray_axis.xyz);
    float pixel = picture.y * length(ray_up.xyz);
    if (ray_axis.w > 0.0) pixel *= max(abs(along), 1.0e-6);
    return surface_way.x * max(0.0625 * pixel, 4.0 * cubics.z);
}
