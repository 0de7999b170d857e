// A billboard's picture: with edges where alpha is half or more, or blended.
#include "output.glsl"

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

vec3 seenRadiance(vec3 colour) {
    vec3 radiance = mix(colour, oneColour.rgb, oneColour.a) * litRadiance;
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
