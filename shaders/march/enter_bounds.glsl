// Rays march all of their part inside the bounds.
void enter_beam(inout Ray ray) {}
