// The picture of a slab of a cloud that was captured from an eye nearby, where its plane is.
#include "cloud-pixel.glsl"

uniform sampler2D impostor; // rgb: radiance, premultiplied; a: fraction of light that passes
uniform sampler2D impostorPlaces; // r: metres behind the plane, times coverage; g: coverage
uniform vec3 slabRight;
uniform vec3 slabUp;
uniform vec3 slabForward;
uniform vec3 eyeAtSlab; // from the eye of the picture to this one, along these axes, metres
uniform vec4 slab; // x: from the eye of the picture to its plane, metres; yz: half of 1 / tangents of half its sides;
                   // w: present extinction divided by that of the picture

const float FAINTEST = 1e-5; // coverage

float takenBy(float depth) {
    return depth < 1e-2 ? depth * (1.0 - depth * (0.5 - depth / 6.0)) : 1.0 - exp(-depth);
}

// Optical depth: half floats are exact for little coverage and for little light that passes.
float depthOf(float covered, float passing) {
    return covered < 0.5 ? -log(1.0 - covered) : -log(max(passing, 1e-7));
}

void main() {
    CloudPixel at = cloudPixel();
    float along = dot(at.ray, slabForward);
    float metres = (slab.x - eyeAtSlab.z) / along;
    vec2 across = (metres * vec2(dot(at.ray, slabRight), dot(at.ray, slabUp)) + eyeAtSlab.xy) / slab.x;
    vec2 texel = 0.5 + slab.yz * across;
    if (!(along > 0.0) || any(lessThan(texel, vec2(0.0))) || any(greaterThan(texel, vec2(1.0)))) {
        discard;
    }
    vec4 place = textureLod(impostorPlaces, texel, 0.0);
    if (!(place.g > FAINTEST)) {
        discard;
    }
    vec4 seen = textureLod(impostor, texel, 0.0);
    float covered = place.g;
    if (slab.w != 1.0) {
        covered = takenBy(slab.w * depthOf(place.g, seen.a));
        seen.rgb *= covered / place.g;
    }
    metres += place.r / place.g;
    if (metres < at.visible.x || metres > at.visible.y) {
        discard;
    }
    writeCloud(at, seen.rgb, covered, metres);
}
