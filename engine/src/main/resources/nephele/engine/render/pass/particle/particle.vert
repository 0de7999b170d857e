// A square that faces the eye, for each particle of a sheet. Stretched ones are turned to their direction.
#include "frame.glsl"
#include "view-clip.glsl"
#ifdef FOG
#include "fog.glsl"
#endif
#ifdef AIR
#include "air.glsl"
#endif

layout(location = 0) in vec2 corner; // -1 or 1

// Three texels for each particle, the farthest first: place from the eye and half the width; premultiplied radiance and
// opacity; stretch to either side, of a billow the relief of its light (see ParticleLight), and the picture, with its
// rotation in turns as the fraction.
uniform samplerBuffer particles;
uniform float pixelPerMetre; // edge of a pixel at a metre's distance

out vec4 covering;
out vec2 place; // in the square, -1 to 1
flat out int picture;
flat out vec2 relief; // brightness of the front of a billow by its slope, along the axes of the square
flat out float fadeMetres; // distance before a surface within which the particle fades

const float TURN = 6.2831853;
const float NEAREST = 0.1; // metres; nearer particles are invisible

// Returns what the eye sees of premultiplied light through the air, and of the air before the particle.
vec4 throughDistance(vec4 seen, vec3 relative) {
#ifdef AIR
    Air air = airAlong(relative);
    seen.rgb = seen.rgb * air.transmittance + seen.a * air.inScatter;
#endif
#ifdef FOG
    float clear = throughFog(relative);
    seen.rgb = seen.rgb * clear + seen.a * (1.0 - clear) * fog.rgb;
#endif
#ifdef MIRRORS
    seen.rgb *= mirrorTint.rgb;
#endif
    return seen;
}

void main() {
    int first = 3 * (gl_InstanceID * PER_SHEET + gl_VertexID / 4);
    vec4 at = texelFetch(particles, first);
    vec4 light = texelFetch(particles, first + 1);
    vec4 stretch = texelFetch(particles, first + 2);
    vec3 relative = at.xyz;
    float metres = max(length(relative), 1e-4);
    vec3 ahead = relative / metres;
    vec3 up = viewUp.xyz - ahead * dot(viewUp.xyz, ahead);
    up /= max(length(up), 1e-6);
    vec3 right = cross(ahead, up);

    // What is thinner than a pixel is drawn a pixel wide and as much fainter.
    float halfWidth = max(at.w, 0.6 * pixelPerMetre * metres);
    vec4 seen = light * (at.w / max(halfWidth, 1e-9));
    vec2 along = vec2(dot(stretch.xyz, right), dot(stretch.xyz, up));
    picture = int(stretch.w);
    bool isBillow = picture >= BILLOW && picture < TONGUE;
    float length2 = isBillow ? 0.0 : length(along);
    float angle = fract(stretch.w) * TURN;
    vec2 axis = length2 > 1e-6 ? along / length2 : vec2(-sin(angle), cos(angle));
    relief = isBillow ? vec2(dot(along, vec2(axis.y, -axis.x)), dot(along, axis)) : vec2(0.0);
    vec2 offset = halfWidth * corner.x * vec2(axis.y, -axis.x) + (halfWidth + length2) * corner.y * axis;

    seen *= clamp((metres - NEAREST) / max(2.0 * halfWidth, NEAREST), 0.0, 1.0);

    vec3 position = relative + offset.x * right + offset.y * up;
    covering = at.w > 0.0 ? throughDistance(seen, relative) : vec4(0.0);
    place = corner;
    fadeMetres = 0.6 * halfWidth;
    clipToView(position);
    gl_Position = at.w > 0.0 ? clipFromRelative * vec4(position, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
