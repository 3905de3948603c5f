// Bounds F and its slope over a piece of the rays, over the box around it.
REAL4 bounds_of_piece(ProofRay ray, REAL low, REAL high) {
    return bounds_over(ray, box_around(ray, low, high));
}
