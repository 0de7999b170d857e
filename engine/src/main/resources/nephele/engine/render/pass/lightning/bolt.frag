// A segment of a line under a disc of the weight 3 / (pi R^2) (1 - d^2 / R^2)^2, whose integral over the picture is 1: lines
// add up to the same light however they are divided into segments, and whatever the disc's radius R.
#include "output.glsl"

flat in vec4 ends;
flat in vec3 lightBegin;
flat in vec3 lightEnd;
flat in float radius;

const float PER_DISC = 0.954929659; // 3 / pi

// The integral of (c - u^2)^2 from 0 on.
float integral(float c, float u) {
    float square = u * u;
    return u * (c * c - square * (2.0 / 3.0 * c - 0.2 * square));
}

void main() {
    vec2 way = ends.zw - ends.xy;
    float pixels = length(way);
    if (!(pixels > 0.0)) {
        discard;
    }
    vec2 along = way / pixels;
    vec2 from = (gl_FragCoord.xy - ends.xy) / radius;
    float across = dot(from, vec2(-along.y, along.x));
    float begin = -dot(from, along);
    float c = 1.0 - across * across;
    if (c <= 0.0) {
        discard;
    }
    float most = sqrt(c);
    float first = clamp(begin, -most, most);
    float last = clamp(begin + pixels / radius, -most, most);
    float share = clamp((0.5 * (first + last) - begin) * radius / pixels, 0.0, 1.0);
    float weight = PER_DISC / radius * (integral(c, last) - integral(c, first));
    vec3 light = min(weight * mix(lightBegin, lightEnd, share), 65504.0);
#ifdef OUTPUT_DIRECT
    light = toneMapped(light, exposureFactor());
#endif
    pixel = vec4(light, 0.0);
}
