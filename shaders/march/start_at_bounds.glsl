// Where a ray begins to march.
float ray_start(Ray ray) {
    return ray.t_near;
}
