// Scales a picture up, in display values. Rows are counted from the bottom, texel centres are whole numbers.

uniform sampler2D smallPicture;

in vec2 st;

layout(location = 0) out vec4 pixel;

#if defined(SHARP_BILINEAR)
// The weights of the four nearest texels, each moved away from one half by a factor.
vec3 interpolated() {
    vec2 size = vec2(textureSize(smallPicture, 0));
    vec2 place = st * size - 0.5;
    vec2 first = floor(place);
    vec2 weight = clamp((place - first - 0.5) * STEEPNESS + 0.5, 0.0, 1.0);
    return texture(smallPicture, (first + weight + 0.5) / size).rgb;
}
#elif defined(EDGE_ADAPTIVE)
// "Edge Adaptive Spatial Upsampling" of FidelityFX Super Resolution 1 (Timothy Lottes, AMD 2021): Lanczos-like weights of
// twelve texels, turned into the direction of the edge and drawn out along it, limited to the range of the four nearest
// texels, so that no halo appears. Departures: exact division and square root, and the weights' sum over all twelve.
//
//   nn  oo        row + 2
//  ii jj kk ll    row + 1
//  ee ff gg hh    row
//     bb cc       row - 1

struct Edge {
    vec2 gradient;
    float strength; // 0 to 2
};

// Adds what one of the four nearest texels knows of the edge.
void look(inout Edge edge, float weight, float below, float left, float centre, float right, float above) {
    vec2 across = vec2(right - left, above - below);
    vec2 steepest = max(abs(vec2(right, above) - centre), abs(centre - vec2(left, below)));
    vec2 sharpness = clamp(abs(across) / max(steepest, 1e-5), 0.0, 1.0);
    edge.gradient += weight * across;
    edge.strength += weight * dot(sharpness, sharpness);
}

float luma(vec3 colour) {
    return dot(colour, vec3(0.5, 1.0, 0.5));
}

// x and y: axes of the kernel in texels, as columns; lobe and its end.
struct Kernel {
    mat2 axes;
    float lobe;
    float end;
};

void tap(inout vec4 sum, vec3 colour, vec2 distance, Kernel kernel) {
    vec2 turned = distance * kernel.axes;
    float squared = min(dot(turned, turned), kernel.end);
    float base = 0.4 * squared - 1.0;
    float window = kernel.lobe * squared - 1.0;
    float weight = (1.5625 * base * base - 0.5625) * window * window;
    sum += vec4(colour, 1.0) * weight;
}

vec3 interpolated() {
    ivec2 most = textureSize(smallPicture, 0) - 1;
    vec2 place = st * vec2(most + 1) - 0.5;
    vec2 part = fract(place);
    ivec2 at = ivec2(floor(place));
    ivec4 x = clamp(ivec4(at.x - 1, at.x, at.x + 1, at.x + 2), 0, most.x);
    ivec4 y = clamp(ivec4(at.y - 1, at.y, at.y + 1, at.y + 2), 0, most.y);
    vec3 bb = texelFetch(smallPicture, ivec2(x.y, y.x), 0).rgb;
    vec3 cc = texelFetch(smallPicture, ivec2(x.z, y.x), 0).rgb;
    vec3 ee = texelFetch(smallPicture, ivec2(x.x, y.y), 0).rgb;
    vec3 ff = texelFetch(smallPicture, ivec2(x.y, y.y), 0).rgb;
    vec3 gg = texelFetch(smallPicture, ivec2(x.z, y.y), 0).rgb;
    vec3 hh = texelFetch(smallPicture, ivec2(x.w, y.y), 0).rgb;
    vec3 ii = texelFetch(smallPicture, ivec2(x.x, y.z), 0).rgb;
    vec3 jj = texelFetch(smallPicture, ivec2(x.y, y.z), 0).rgb;
    vec3 kk = texelFetch(smallPicture, ivec2(x.z, y.z), 0).rgb;
    vec3 ll = texelFetch(smallPicture, ivec2(x.w, y.z), 0).rgb;
    vec3 nn = texelFetch(smallPicture, ivec2(x.y, y.w), 0).rgb;
    vec3 oo = texelFetch(smallPicture, ivec2(x.z, y.w), 0).rgb;

    float b = luma(bb), c = luma(cc), e = luma(ee), f = luma(ff), g = luma(gg), h = luma(hh);
    float i = luma(ii), j = luma(jj), k = luma(kk), l = luma(ll), n = luma(nn), o = luma(oo);
    Edge edge = Edge(vec2(0.0), 0.0);
    look(edge, (1.0 - part.x) * (1.0 - part.y), b, e, f, g, j);
    look(edge, part.x * (1.0 - part.y), c, f, g, h, k);
    look(edge, (1.0 - part.x) * part.y, f, i, j, k, n);
    look(edge, part.x * part.y, g, j, k, l, o);

    float squared = dot(edge.gradient, edge.gradient);
    vec2 direction = squared < 1.0 / 32768.0 ? vec2(1.0, 0.0) : edge.gradient * inversesqrt(squared);
    float strength = 0.25 * edge.strength * edge.strength; // 0 to 1
    float stretch = 1.0 / max(abs(direction.x), abs(direction.y)); // 1 along the axes, √2 on diagonals
    float across = 1.0 + (stretch - 1.0) * strength;
    float along = 1.0 - 0.5 * strength;
    float lobe = 0.5 - 0.29 * strength;
    Kernel kernel = Kernel(
            mat2(across * direction, along * vec2(-direction.y, direction.x)), lobe, 1.0 / lobe);

    vec4 sum = vec4(0.0);
    tap(sum, bb, vec2(0.0, -1.0) - part, kernel);
    tap(sum, cc, vec2(1.0, -1.0) - part, kernel);
    tap(sum, ee, vec2(-1.0, 0.0) - part, kernel);
    tap(sum, ff, -part, kernel);
    tap(sum, gg, vec2(1.0, 0.0) - part, kernel);
    tap(sum, hh, vec2(2.0, 0.0) - part, kernel);
    tap(sum, ii, vec2(-1.0, 1.0) - part, kernel);
    tap(sum, jj, vec2(0.0, 1.0) - part, kernel);
    tap(sum, kk, vec2(1.0, 1.0) - part, kernel);
    tap(sum, ll, vec2(2.0, 1.0) - part, kernel);
    tap(sum, nn, vec2(0.0, 2.0) - part, kernel);
    tap(sum, oo, vec2(1.0, 2.0) - part, kernel);
    return clamp(sum.rgb / sum.w, min(min(ff, gg), min(jj, kk)), max(max(ff, gg), max(jj, kk)));
}
#else
vec3 interpolated() {
    return texture(smallPicture, st).rgb;
}
#endif

void main() {
    pixel = vec4(interpolated(), 1.0);
}
