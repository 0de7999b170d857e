// Marches the ray of a pixel through one cloud, as far as surfaces let it.
#include "output.glsl"
#include "view-distance.glsl"
#include "cloud-march.glsl"

in vec3 direction;

uniform sampler2D viewDepth;
uniform vec3 irradiance; // of the sun at the cloud
uniform vec3 skyAbove; // mean radiance of the upper half of the sky
uniform vec3 skyBelow;

void main() {
    float unit = length(direction);
    vec3 ray = direction / unit;
    float windowDepth = texelFetch(viewDepth, ivec2(gl_FragCoord.xy), 0).r;
    vec2 visible = vec2(0.0, windowDepth < 1.0 ? axisMetres(windowDepth) * unit : 1e30);
#ifdef PORTALS
    float towardsClip = dot(viewClip.xyz, ray);
    if (towardsClip > 0.0) {
        visible.x = max(visible.x, -viewClip.w / towardsClip);
    }
#endif
    vec2 inside = insideCloud(ray);
    visible = vec2(max(visible.x, inside.x), min(visible.y, inside.y));
    if (!(visible.x < visible.y)) {
        discard;
    }
    CloudRay cloud = marchedCloud(ray, visible);
    vec3 radiance = cloud.sunlight * irradiance + cloud.above * skyAbove + cloud.below * skyBelow;
    float covered = 1.0 - cloud.transmittance;
#ifdef FOG
    float clear = exp(-fog.a * cloud.metres);
    radiance = radiance * clear + fog.rgb * covered * (1.0 - clear);
#endif
#ifdef MIRRORS
    radiance *= mirrorTint.rgb;
#endif
    pixel = vec4(min(radiance, 65504.0), covered);
}
