// Rays march their whole part inside the bounds.
void enter_beam(inout Ray ray) {}
