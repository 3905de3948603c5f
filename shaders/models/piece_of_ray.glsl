// Evaluates the model of F over a piece of the rays.
Model coordinate_of(REAL anchor, REAL direction, REAL middle, REAL half_piece, REAL3 axis) {
    precise REAL way = middle * direction;
    precise REAL c = anchor + way;
    precise REAL l = half_piece * direction;
    REAL off = md_up(2.0 * IM_ROUNDING * (abs(way) + abs(c) + abs(l)));
    return md_coordinate(c, l, tube.x * axis, off);
}

Model model_of_piece(ProofRay ray, REAL middle, REAL half_piece) {
    REAL3 a = ray.anchor, d = ray.direction;
    return field_model(coordinate_of(a.x, d.x, middle, half_piece, REAL3(1.0, 0.0, 0.0)),
                       coordinate_of(a.y, d.y, middle, half_piece, REAL3(0.0, 1.0, 0.0)),
                       coordinate_of(a.z, d.z, middle, half_piece, REAL3(0.0, 0.0, 1.0)));
}
