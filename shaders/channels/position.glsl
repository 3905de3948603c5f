// Channel P: point in world coordinates; 0 where nothing is hit.
layout(location = POSITION_LOCATION) out vec4 position_out;

void write_position(Ray ray, Hit hit, int verdict) {
    position_out = on_surface(verdict) ? vec4((to_world * vec4(hit.position, 1.0)).xyz, 0.0) : vec4(0.0);
}
