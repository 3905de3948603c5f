// Where a ray begins to march: its beam's start, see beam.frag.
uniform sampler2D beam_texture;

float ray_start(Ray ray) {
    float tau = texelFetch(beam_texture, ivec2(gl_FragCoord.xy) / BLOCK, 0).x;
    return max(ray.t_near, tau * ray.to_eye);
}
