// Draws a cloud as a sheet of octaves of noise.
#include "cloud-pixel.glsl"
#include "cloud-sheet.glsl"
#include "cloud-octaves.glsl"

uniform vec3 irradiance; // of the sun at the cloud
uniform vec3 skyAbove; // mean radiance of the upper half of the sky
uniform vec3 skyBelow;

float pixelAngle; // radians from ray to ray in the middle of the picture

vec3 columnAt(vec3 place, SheetPart part) {
    float slant = part.passed / cloudHalf.y;
    float edge = pixelAngle * part.metres * slant;
    return columnOfOctaves(place.xz, edge) * vec3(1.0, 0.5, 1.0 / 3.0);
}

void main() {
#ifdef WHOLE
    pixelAngle = layerStep.y * length(viewUp.xyz);
#else
    pixelAngle = length(dFdy(direction));
#endif
    CloudPixel at = cloudPixel();
    CloudRay cloud = throughSheet(at.ray, at.visible);
    if (cloud.transmittance == 1.0) {
        discard;
    }
    vec3 radiance = cloud.sunlight * irradiance + cloud.above * skyAbove + cloud.below * skyBelow;
    writeCloud(at, radiance, 1.0 - cloud.transmittance, cloud.metres);
}
