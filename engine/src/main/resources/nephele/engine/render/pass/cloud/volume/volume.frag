// Marches the ray of a pixel through one cloud.
#include "cloud-pixel.glsl"
#include "cloud-march.glsl"

#if !defined(BY_FLASH) && !defined(OF_BOLT)
uniform vec3 irradiance; // of the sun at the cloud
uniform vec3 skyAbove; // mean radiance of the upper half of the sky
uniform vec3 skyBelow;
#endif

void main() {
    CloudPixel at = cloudPixel();
    vec2 inside = insideCloud(at.ray);
    vec2 visible = vec2(max(at.visible.x, inside.x), min(at.visible.y, inside.y));
    if (!(visible.x < visible.y)) {
        discard;
    }
    CloudRay cloud = marchedCloud(at.ray, visible, stepOffset(at.place));
#if defined(BY_FLASH)
    writeCloud(at, cloud.sunlight * flashIntensity, 1.0 - cloud.scaled, cloud.metres);
#elif defined(OF_BOLT)
    pixel = vec4(0.0, 0.0, 0.0, 1.0 - cloud.transmittance);
#else
    vec3 radiance = cloud.sunlight * irradiance + cloud.above * skyAbove + cloud.below * skyBelow;
    writeCloud(at, radiance, 1.0 - cloud.transmittance, cloud.metres);
#endif
}
