// Marches the ray of a pixel through one cloud. WHOLE: the cloud as if there were no surfaces, at low resolution; MIXED:
// only pixels whose surface is among the clouds.
#include "output.glsl"
#include "cloud-march.glsl"
#ifndef WHOLE
#include "view-distance.glsl"
#endif
#ifdef MIXED
#include "cloud-ranges.glsl"
#endif

#ifdef WHOLE
#include "layer-ray.glsl"
layout(location = 1) out vec4 place; // times coverage: r: kilometres to the cloud; gb: motionAcross; a: coverage
uniform vec3 marchedSquare; // x: side of the square of rays of which one is marched; y, z: that one's place from the middle
uniform vec3 blown; // how far the wind has carried the cloud since the layer before, metres
#else
in vec3 direction;
#endif

#ifndef WHOLE
uniform sampler2D viewDepth;
#endif
uniform vec3 irradiance; // of the sun at the cloud
uniform vec3 skyAbove; // mean radiance of the upper half of the sky
uniform vec3 skyBelow;

// The part of the ray in front of the pixel's surface and, in a view through an opening, behind that.
vec2 visiblePart(vec3 ray, float unit) {
    vec2 visible = vec2(0.0, NEVER);
#ifndef WHOLE
    float windowDepth = texelFetch(viewDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (windowDepth < 1.0) {
        visible.y = axisMetres(windowDepth) * unit;
    }
#endif
#ifdef PORTALS
    float towardsClip = dot(viewClip.xyz, ray);
    if (towardsClip > 0.0) {
        visible.x = -viewClip.w / towardsClip;
    }
#endif
    return visible;
}

// Spreads the first samples of neighbouring rays over a step (Jimenez 2014, "Next Generation Post Processing in Call of
// Duty: Advanced Warfare", interleaved gradient noise).
float stepOffset(vec2 pixelPlace) {
    return fract(52.9829189 * fract(dot(pixelPlace, vec2(0.06711056, 0.00583715))));
}

#ifdef WHOLE
// The wind's motion along the view's right and upper axes; what it has along the ray cannot be seen and takes the rest.
vec2 motionAcross(vec3 ray) {
    vec3 across = blown - ray * (dot(blown, viewForward.xyz) / dot(ray, viewForward.xyz));
    return vec2(dot(across, normalize(viewRight.xyz)), dot(across, normalize(viewUp.xyz)));
}
#endif

void main() {
#ifdef WHOLE
    vec2 rayPlace = gl_FragCoord.xy * marchedSquare.x + marchedSquare.yz;
    vec3 direction = layerRay(rayPlace);
#else
    vec2 rayPlace = gl_FragCoord.xy;
#endif
    float unit = length(direction);
    vec3 ray = direction / unit;
    vec2 visible = visiblePart(ray, unit);
#ifdef MIXED
    vec2 range = rangeOfClouds(ray);
    if (visible.y <= range.x || visible.y >= range.y) {
        discard;
    }
#endif
    vec2 inside = insideCloud(ray);
    visible = vec2(max(visible.x, inside.x), min(visible.y, inside.y));
    if (!(visible.x < visible.y)) {
        discard;
    }
    CloudRay cloud = marchedCloud(ray, visible, stepOffset(rayPlace));
    vec3 radiance = cloud.sunlight * irradiance + cloud.above * skyAbove + cloud.below * skyBelow;
    float covered = 1.0 - cloud.transmittance;
#ifdef AIR
    Air air = airAlong(ray * cloud.metres);
    radiance = radiance * air.transmittance + covered * air.inScatter;
#endif
#ifdef FOG
    float clear = exp(-fog.a * cloud.metres);
    radiance = radiance * clear + fog.rgb * covered * (1.0 - clear);
#endif
#ifdef MIRRORS
    radiance *= mirrorTint.rgb;
#endif
#ifdef WHOLE
    pixel = vec4(min(radiance, 65504.0), covered);
    place = vec4(covered * vec3(0.001 * cloud.metres, motionAcross(ray)), covered);
#else
    writeCovering(vec4(min(radiance, 65504.0), covered));
#endif
}
