out vec4 color;

void main() { color = chains(pixel_centre.xyxy); }
