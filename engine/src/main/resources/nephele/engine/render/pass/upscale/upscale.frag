// Scales a picture up, in display values.

uniform sampler2D smallPicture;

in vec2 st;

layout(location = 0) out vec4 pixel;

#ifdef CATMULL_ROM
// Catmull-Rom interpolation (Catmull and Rom 1974, "A Class of Local Interpolating Splines"): the four inner texels of each
// row and column come from one bilinear read, and the four corner reads, whose weights are below 1 %, are omitted, as
// Jimenez does ("Filmic SMAA: Sharp Morphological and Temporal Antialiasing", SIGGRAPH 2016 course).
vec3 interpolated() {
    vec2 size = vec2(textureSize(smallPicture, 0));
    vec2 texel = st * size;
    vec2 centre = floor(texel - 0.5) + 0.5;
    vec2 f = texel - centre;
    vec2 before = f * (-0.5 + f * (1.0 - 0.5 * f));
    vec2 first = 1.0 + f * f * (-2.5 + 1.5 * f);
    vec2 after = f * f * (-0.5 + 0.5 * f);
    vec2 inner = 1.0 - before - after;
    vec2 middle = (centre + (inner - first) / inner) / size;
    vec2 low = (centre - 1.0) / size;
    vec2 high = (centre + 2.0) / size;
    vec3 sum = texture(smallPicture, middle).rgb * (inner.x * inner.y)
            + texture(smallPicture, vec2(low.x, middle.y)).rgb * (before.x * inner.y)
            + texture(smallPicture, vec2(high.x, middle.y)).rgb * (after.x * inner.y)
            + texture(smallPicture, vec2(middle.x, low.y)).rgb * (inner.x * before.y)
            + texture(smallPicture, vec2(middle.x, high.y)).rgb * (inner.x * after.y);
    float weight = inner.x * inner.y + (before.x + after.x) * inner.y + inner.x * (before.y + after.y);
    return sum * (1.0 / weight);
}
#else
vec3 interpolated() {
    return texture(smallPicture, st).rgb;
}
#endif

void main() {
    pixel = vec4(interpolated(), 1.0);
}
