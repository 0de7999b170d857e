// The ray of a pixel for one cloud, and what is written of it. WHOLE: as if there were no surfaces, at low resolution.
// BEFORE_SURFACES: as WHOLE, or at every pixel, in front of surfaces. BY_FLASH: a layer as WHOLE, lit by a flash. OF_BOLT: a
// pixel for each point of a bolt, whose ray ends there. BAKED: all pixels of a picture that is kept, without surfaces, air and
// fog. SHARED: another technique may draw a part of the cloud.
#include "output.glsl"
#include "cloud-span.glsl"

#if defined(WHOLE) && !defined(BY_FLASH) && !defined(BEFORE_SURFACES)
#define PLACED
#endif

#if defined(BAKED) || defined(PLACED)
layout(location = 1) out vec4 place; // times coverage: r: kilometres to the cloud; gb: motionAcross; a: coverage. CAPTURED:
                                     // r: metres behind the picture's plane; g: 1
#endif

#ifdef WHOLE
#include "layer-ray.glsl"
uniform vec3 marchedSquare; // x: side of the square of rays of which one is drawn; y, z: that one's place from the middle
#ifdef CAPTURED
uniform float capturedPlane; // distance along the view's axis, metres
#elif defined(PLACED)
uniform vec3 blown; // how far the wind has carried the cloud since the layer before, metres
#endif
#ifdef BEFORE_SURFACES
#include "view-distance.glsl"
uniform sampler2D viewDepth;
uniform sampler2D surfaceCuts; // of surface/cuts.frag
uniform vec3 cut; // one component is 1: what is drawn is in front of x: the nearest, y: the farthest, z: the pixel's own surface
#endif
#elif defined(OF_BOLT)
#include "frame.glsl"
uniform samplerBuffer boltPoints; // xyz: from the bolt's origin, metres
uniform vec3 boltFromEye;
#else
#ifdef QUADS
noperspective
#endif
in vec3 direction; // not of unit length; its part along the view's axis is 1
#ifndef BAKED
#include "view-distance.glsl"
uniform sampler2D viewDepth;
#endif
#endif

#ifdef SHARED
uniform float cloudFraction; // of the optical depth that is drawn
const float THINNEST = 1e-7; // fraction of light that passes; smaller ones are lost in its difference to 1
#endif

struct CloudPixel {
    vec2 place; // in a layer of all rays
    vec3 ray; // unit
    vec2 visible; // from and to which distance surfaces and openings let it see
};

// The part of the ray in front of the pixel's surface and, in a view through an opening, behind that.
vec2 visiblePart(vec3 ray, float unit) {
    vec2 visible = vec2(0.0, NEVER);
#ifdef OF_BOLT
    visible.y = unit;
#elif defined(BEFORE_SURFACES)
    ivec2 pixelPlace = ivec2(gl_FragCoord.xy);
    if (cut.z > 0.0) {
        visible.y = axisMetres(texelFetch(viewDepth, pixelPlace, 0).r) * unit;
    } else {
        vec2 cuts = texelFetch(surfaceCuts, min(pixelPlace, textureSize(surfaceCuts, 0) - 1), 0).rg;
        // Where there is one cut, the farthest is drawn alone.
        visible.y = cut.x > 0.0 && cuts.x == cuts.y ? 0.0 : dot(cut.xy, cuts) * unit;
    }
#elif !defined(WHOLE) && !defined(BAKED)
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

#if defined(PLACED) && !defined(CAPTURED)
// The wind's motion along the view's right and upper axes; what it has along the ray cannot be seen and takes the rest.
vec2 motionAcross(vec3 ray) {
    vec3 across = blown - ray * (dot(blown, viewForward.xyz) / dot(ray, viewForward.xyz));
    return vec2(dot(across, normalize(viewRight.xyz)), dot(across, normalize(viewUp.xyz)));
}
#endif

// Discards pixels that others draw.
CloudPixel cloudPixel() {
#ifdef WHOLE
    vec2 rayPlace = gl_FragCoord.xy * marchedSquare.x + marchedSquare.yz;
    vec3 direction = layerRay(rayPlace);
#elif defined(OF_BOLT)
    vec2 rayPlace = gl_FragCoord.xy;
    vec3 direction = boltFromEye + texelFetch(boltPoints, int(gl_FragCoord.x)).xyz;
    if (dot(direction, viewForward.xyz) <= 0.0) {
        discard;
    }
#else
    vec2 rayPlace = gl_FragCoord.xy;
#endif
    float unit = length(direction);
    vec3 ray = direction / unit;
    vec2 visible = visiblePart(ray, unit);
    return CloudPixel(rayPlace, ray, visible);
}

// Writes the light of a cloud, premultiplied, with air and fog before it. metres: where its visible part is
void writeCloud(CloudPixel at, vec3 radiance, float covered, float metres) {
#ifdef SHARED
    if (cloudFraction < 1.0) {
        float part = covered < 1e-3 ? cloudFraction : (1.0 - pow(max(1.0 - covered, THINNEST), cloudFraction)) / covered;
        radiance *= part;
        covered *= part;
    }
#endif
#ifdef CAPTURED
    pixel = vec4(min(radiance, 65504.0), covered);
    place = vec4(covered * vec2(metres - capturedPlane / dot(at.ray, viewForward.xyz), 1.0), 0.0, covered);
#else
#ifndef BAKED
#ifdef BY_FLASH
    // Air and fog are lit without the flash.
#ifdef AIR
    radiance *= airAlong(at.ray * metres).transmittance;
#endif
#ifdef FOG
    radiance *= throughFog(at.ray * metres);
#endif
#else
#ifdef AIR
    Air air = airAlong(at.ray * metres);
    radiance = radiance * air.transmittance + covered * air.inScatter;
#endif
#ifdef FOG
    float clear = throughFog(at.ray * metres);
    radiance = radiance * clear + fog.rgb * covered * (1.0 - clear);
#endif
#endif
#ifdef MIRRORS
    radiance *= mirrorTint.rgb;
#endif
#endif
#if defined(BY_FLASH) || defined(OF_BOLT)
    pixel = vec4(min(radiance, 65504.0), covered);
#elif defined(BEFORE_SURFACES)
    pixel = vec4(min(radiance, 65504.0), covered);
    if (cut.z > 0.0) {
        writeCovering(pixel);
    }
#elif defined(BAKED)
    pixel = vec4(min(radiance, 65504.0), covered);
    place = covered * vec4(0.001 * metres, 0.0, 0.0, 1.0);
#elif defined(PLACED)
    pixel = vec4(min(radiance, 65504.0), covered);
    place = vec4(covered * vec3(0.001 * metres, motionAcross(at.ray)), covered);
#else
    writeCovering(vec4(min(radiance, 65504.0), covered));
#endif
#endif
}
