// A billboard's picture: with edges where alpha is half or more, or blended.
#include "output.glsl"
#ifdef PUNCTUAL_LIGHTS
#define MOVING_RECEIVER
#include "surface-light.glsl"
#endif

#ifdef SURFACES
#include "view-distance.glsl"
uniform sampler2D viewDepth;
flat in float fadeMetres;
#endif

uniform sampler2DArray sprites; // straight alpha

in vec2 st;
flat in vec3 layers;
in vec3 litRadiance;
in vec3 addedRadiance;
in float passing;
#ifdef AIR
in vec3 airPassing;
#endif
flat in vec4 oneColour;

#ifdef PUNCTUAL_LIGHTS
in vec3 lampPlace;
flat in vec3 toFront;
flat in vec3 bulgeRight;
flat in vec3 bulgeUp;

// Returns the light of lamps, which may be nearer than the vertices are to each other.
vec3 lampLight() {
    Surface s;
    s.baseColour = vec3(1.0);
    s.normal = normalize(toFront + (2.0 * st.x - 1.0) * bulgeRight + (1.0 - 2.0 * st.y) * bulgeUp);
    s.faceNormal = s.normal;
    s.anchorPosition = lampPlace;
    REFLECTANCE r = reflectanceOf(s);
#ifdef LIGHT_PARTS
    r = shown(r);
#endif
    return min(allLights(r, s), vec3(MAX_RADIANCE));
}
#endif

vec3 seenRadiance(vec3 colour) {
    vec3 lit = litRadiance;
#ifdef PUNCTUAL_LIGHTS
    lit += lampLight();
#endif
    vec3 radiance = mix(colour, oneColour.rgb, oneColour.a) * lit;
#ifdef AIR
    radiance *= airPassing;
#endif
    return radiance * passing + addedRadiance;
}

void main() {
    vec4 texel = texture(sprites, vec3(st, layers.x));
#ifdef BLENDED
#ifdef ANIMATED
    if (layers.z > 0.0) {
        texel = mix(texel, texture(sprites, vec3(st, layers.y)), layers.z);
    }
#endif
#ifdef SURFACES
    float behind = axisMetres(texelFetch(viewDepth, ivec2(gl_FragCoord.xy), 0).r) - 1.0 / gl_FragCoord.w;
    texel.a *= clamp(behind / fadeMetres, 0.0, 1.0);
#endif
    vec3 radiance = min(seenRadiance(texel.rgb), vec3(65504.0));
#ifdef MIRRORS
    radiance *= mirrorTint.rgb;
#endif
    writeCovering(vec4(radiance * texel.a, texel.a));
#else
#ifdef MULTISAMPLED
    // The share of the pixel within the edge, from how alpha changes (Golus 2017, "Anti-aliased Alpha Test").
    float covered = clamp((texel.a - 0.5) / max(fwidth(texel.a), 1e-4) + 0.5, 0.0, 1.0);
    if (covered <= 0.0) {
        discard;
    }
#else
    if (texel.a < 0.5) {
        discard;
    }
#endif
    writeRadiance(seenRadiance(texel.rgb));
#ifdef MULTISAMPLED
    pixel.a = covered;
#endif
#endif
}
