layout(rgba32f, binding = 0) writeonly uniform image2D stored;

void main() { imageStore(stored, ivec2(gl_GlobalInvocationID.xy), chains(pixel_centre.xyxy)); }
