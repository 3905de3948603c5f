// The distance to what is seen of the surfaces so far, along the ray that all share.
layout(location = WAY_LOCATION) out float way;

const float NO_END = 1.0e30;
