// The first surface has none before it.
void keep_nearest(Ray ray, RayState s) {}
