// Draws a cloud as a sheet whose columns are in a texture.
#include "cloud-pixel.glsl"
#include "cloud-sheet.glsl"

uniform sampler2DArray sheetColumns; // the columns of each box at the last time, then at the next
uniform vec3 irradiance; // of the sun at the cloud
uniform vec3 skyAbove; // mean radiance of the upper half of the sky
uniform vec3 skyBelow;

// A layer of the columns under a cubic B-spline, from four bilinear samples (Sigg and Hadwiger 2005, "Fast Third-Order
// Texture Filtering", GPU Gems 2).
vec3 smoothed(vec2 across, float layer) {
    vec2 size = vec2(textureSize(sheetColumns, 0));
    vec2 texel = across * size - 0.5;
    vec2 f = fract(texel);
    vec2 base = texel - f;
    vec2 rest = 1.0 - f;
    vec2 before = rest * rest * rest / 6.0;
    vec2 after = f * f * f / 6.0;
    vec2 at = 2.0 / 3.0 - 0.5 * f * f * (2.0 - f);
    vec2 next = 1.0 - before - after - at;
    vec2 low = (base - 0.5 + at / (before + at)) / size;
    vec2 high = (base + 1.5 + after / (next + after)) / size;
    vec2 weight = next + after;
    vec3 a = textureLod(sheetColumns, vec3(low, layer), 0.0).rgb;
    vec3 b = textureLod(sheetColumns, vec3(high.x, low.y, layer), 0.0).rgb;
    vec3 c = textureLod(sheetColumns, vec3(low.x, high.y, layer), 0.0).rgb;
    vec3 d = textureLod(sheetColumns, vec3(high, layer), 0.0).rgb;
    return mix(mix(a, b, weight.x), mix(c, d, weight.x), weight.y);
}

vec3 columnOf(vec3 place, float box) {
    vec2 across = acrossBox(place, box);
    vec3 last = smoothed(across, 2.0 * box);
    return cells.w > 0.0 ? mix(last, smoothed(across, 2.0 * box + 1.0), cells.w) : last;
}

vec3 columnAt(vec3 place, SheetPart part) {
    vec2 box = boxOf(place);
    vec3 column = columnOf(place, box.x);
    return box.y > 0.0 ? mix(column, columnOf(place, box.x + 1.0), box.y) : column;
}

void main() {
    CloudPixel at = cloudPixel();
    CloudRay cloud = throughSheet(at.ray, at.visible);
    if (cloud.transmittance == 1.0) {
        discard;
    }
    vec3 radiance = cloud.sunlight * irradiance + cloud.above * skyAbove + cloud.below * skyBelow;
    writeCloud(at, radiance, 1.0 - cloud.transmittance, cloud.metres);
}
