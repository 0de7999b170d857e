// A particle's picture in its square, faded where a surface cuts it.
#include "output.glsl"
#ifdef SURFACES
#include "view-distance.glsl"
uniform sampler2D viewDepth;
#endif
#ifdef PICTURES
uniform sampler2DArray pictures; // a layer for each picture from BILLOW on
#endif

in vec4 covering;
in vec2 place;
flat in int picture;
flat in vec2 relief;
flat in float fadeMetres;

float spot() {
    if (picture == STREAK) {
        vec2 inside = 1.0 - place * place;
        return inside.x * inside.x * inside.y;
    }
    float left = max(1.0 - dot(place, place), 0.0);
    return left * left;
}

// Returns coverage, and the factor on the light.
vec2 lookAtPlace() {
#ifdef PICTURES
    if (picture >= BILLOW) {
        vec3 texel = texture(pictures, vec3(0.5 + 0.5 * place, float(picture - BILLOW))).rgb;
        return vec2(texel.r, max(1.0 + dot(2.0 * texel.gb - 1.0, relief), 0.0));
    }
#endif
    return vec2(spot(), 1.0);
}

void main() {
    vec2 seenLook = lookAtPlace();
    float covered = seenLook.x;
#ifdef SURFACES
    float behind = axisMetres(texelFetch(viewDepth, ivec2(gl_FragCoord.xy), 0).r) - 1.0 / gl_FragCoord.w;
    covered *= clamp(behind / fadeMetres, 0.0, 1.0);
#endif
    vec4 seen = covered * vec4(seenLook.y * covering.rgb, covering.a);
    writeCovering(vec4(min(seen.rgb, 65504.0), seen.a));
}
