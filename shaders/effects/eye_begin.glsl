// Returns the t at which a pixel's ray begins, before it is clipped to the bounds.
float ray_begin(Ray ray) {
    return -length(ray_axis.xyz + ray_axis.w * (ray.anchor - ray_origin.xyz));
}
