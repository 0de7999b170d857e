// The rectangle of pixels around a segment of a bolt.
#include "frame.glsl"
#include "view-clip.glsl"
#ifdef FOG
#include "fog.glsl"
#endif
#ifdef AIR
#include "air.glsl"
#endif

layout(location = 0) in vec2 corner; // -1 or 1: along the segment and across

uniform samplerBuffer boltPoints; // xyz: from the bolt's origin, metres; w: share of the current, negative for the first of a line
uniform vec3 boltFromEye;
uniform vec3 intensityPerMetre; // radiant, of a channel with the whole current
uniform vec3 brightness; // of the main channel, and of branches; z: edge of a pixel at a metre's distance
uniform vec3 spreading; // share of the light; radius over which it is spread, pixels, 0 for the channel's; points of a step
uniform vec2 halfPicture; // pixels
#ifdef CLOUDS
uniform sampler2D boltTransmittance; // by point
#endif

flat out vec4 ends; // pixels
flat out vec3 lightBegin; // per pixel of the line's length
flat out vec3 lightEnd;
flat out float radius; // pixels

const float NEAREST = 0.5; // metres along the view's axis
const float WIDTH = 0.35; // of the channel, metres
const float THINNEST = 1.3; // pixels
const float MAIN = 0.999; // share of the current from which on a channel is the main one

// Returns the light of a place on the line, per pixel of its length: the radiance of a pixel that one pixel of it is in.
vec3 lightOf(int point, vec4 place, vec3 relative) {
    float share = abs(place.w);
    float metres = max(length(relative), NEAREST);
    vec3 light = intensityPerMetre * (share * (share > MAIN ? brightness.x : brightness.y) * spreading.x);
    light /= metres * brightness.z;
#ifdef CLOUDS
    light *= texelFetch(boltTransmittance, ivec2(point, 0), 0).r;
#endif
#ifdef AIR
    light *= airAlong(relative).transmittance;
#endif
#ifdef FOG
    light *= throughFog(relative);
#endif
#ifdef MIRRORS
    light *= mirrorTint.rgb;
#endif
    return light;
}

vec2 pixelOf(vec4 clip) {
    return (clip.xy / clip.w + 1.0) * halfPicture;
}

void main() {
    int from = (gl_VertexID / 4) * int(spreading.z);
    int to = from + int(spreading.z);
    vec4 begin = texelFetch(boltPoints, from);
    vec4 end = texelFetch(boltPoints, to);
    vec3 a = boltFromEye + begin.xyz;
    vec3 b = boltFromEye + end.xyz;
    lightBegin = lightOf(from, begin, a);
    lightEnd = lightOf(to, end, b);
    float aheadA = dot(a, viewForward.xyz);
    float aheadB = dot(b, viewForward.xyz);
    if (end.w < 0.0 || max(aheadA, aheadB) <= NEAREST) {
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
        return;
    }
    a = aheadA < NEAREST ? mix(a, b, (NEAREST - aheadA) / (aheadB - aheadA)) : a;
    b = aheadB < NEAREST ? mix(b, a, (NEAREST - aheadB) / (aheadA - aheadB)) : b;
    vec4 clipA = clipFromRelative * vec4(a, 1.0);
    vec4 clipB = clipFromRelative * vec4(b, 1.0);
    ends = vec4(pixelOf(clipA), pixelOf(clipB));
    float nearest = max(NEAREST, min(length(a), length(b)));
    radius = spreading.y > 0.0 ? spreading.y : max(THINNEST, 0.8 * WIDTH / (nearest * brightness.z));
    vec2 way = ends.zw - ends.xy;
    float pixels = length(way);
    vec2 along = pixels > 1e-4 ? way / pixels : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    bool isEnd = corner.x > 0.0;
    vec4 clip = isEnd ? clipB : clipA;
    vec2 offset = (radius + 1.0) * (corner.x * along + corner.y * across);
    clip.xy += offset / halfPicture * clip.w;
    clipToView(isEnd ? b : a);
    gl_Position = clip;
}
