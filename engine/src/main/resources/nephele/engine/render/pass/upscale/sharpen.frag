uniform sampler2D smallPicture;
layout(location = 0) out vec4 pixel;
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 most = textureSize(smallPicture, 0) - 1;
    vec3 c = texelFetch(smallPicture, at, 0).rgb;
    vec3 n = texelFetch(smallPicture, ivec2(at.x, min(at.y + 1, most.y)), 0).rgb;
    vec3 s = texelFetch(smallPicture, ivec2(at.x, max(at.y - 1, 0)), 0).rgb;
    vec3 e = texelFetch(smallPicture, ivec2(min(at.x + 1, most.x), at.y), 0).rgb;
    vec3 w = texelFetch(smallPicture, ivec2(max(at.x - 1, 0), at.y), 0).rgb;
    vec3 low = min(min(n, s), min(e, w));
    vec3 high = max(max(n, s), max(e, w));
    vec3 lobe = vec3(LOBE);
#ifdef RCAS
    vec3 hitMin = low / (4.0 * max(high, 1e-4));
    vec3 hitMax = (1.0 - high) / min(4.0 * low - 4.0, -1e-4);
    vec3 l3 = max(-hitMin, hitMax);
    float l = max(-0.1875, min(max(l3.r, max(l3.g, l3.b)), 0.0)) * LOBE * 4.0;
    vec3 sharp = (c + l * (n + s + e + w)) / (1.0 + 4.0 * l);
#else
    vec3 sharp = c + LOBE * (4.0 * c - n - s - e - w);
#endif
    pixel = vec4(clamp(sharp, min(low, c) - SLACK / 255.0, max(high, c) + SLACK / 255.0), 1.0);
}
