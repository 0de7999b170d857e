// A billboard, turned to the eye of its view and lit as a bush is: the parts of its image face where those of a ball would.
// The light of sun and sky varies slowly and comes from the vertices, that of lamps from the fragments.
#define MOVING_RECEIVER
#include "frame.glsl"
#include "view-clip.glsl"
#ifdef FOG
#include "fog.glsl"
#endif
#ifdef AIR
#include "air.glsl"
#endif
#include "surface-light.glsl"

uniform int perSheet; // images of an instance
uniform int verticesEach; // of an image
#define PER_SHEET perSheet
#define VERTICES verticesEach
#include "billboard.glsl"

uniform vec3 eyeHigh; // from the anchor
uniform vec3 eyeLow;
#ifdef OBSERVER
uniform vec3 observer; // from the anchor; faced instead of the eye
#endif
#ifdef BOUNCED_LIGHT
uniform samplerBuffer bouncedLight; // a texel an image: the radiance of a white surface that only other surfaces light
#endif

out vec2 st;
flat out vec3 layers; // this frame's, the next one's and its share
out vec3 litRadiance; // of white
out vec3 addedRadiance; // by air and fog
out float passing; // share of the light behind fog
#ifdef AIR
out vec3 airPassing;
#endif
flat out vec4 oneColour;
#ifdef PUNCTUAL_LIGHTS
out vec3 lampPlace; // from the anchor
flat out vec3 toFront; // unit
flat out vec3 bulgeRight; // from there to the direction of the right border
flat out vec3 bulgeUp;
#endif
#ifdef SURFACES
flat out float fadeMetres; // in front of a surface, over which the picture fades

const float FADE_SHARE = 0.15; // of the width
#endif

// How round a billboard is lit: a corner faces so far to the side and above.
const float BULGE = java(level.billboard.PlantedBillboards.BULGE);
// Leaves let light through: faces are turned towards the sun.
const float THROUGH = java(level.billboard.PlantedBillboards.THROUGH);
// The share of the sun's light that leaves which lie behind others receive on the mean.
const float BETWEEN_LEAVES = java(level.billboard.PlantedBillboards.BETWEEN_LEAVES);

vec3 lightAt(Surface s) {
    REFLECTANCE r = reflectanceOf(s);
    vec3 sum = vec3(0.0);
#ifdef AMBIENT
    sum += ambientLight(r, s);
#endif
#ifdef LIGHT_PARTS
    r = shown(r);
#endif
#ifdef FLASH
    sum += flashLight(r, s);
#endif
#ifdef SUN
    s.normal = normalize(s.normal + THROUGH * sunDirection);
    s.faceNormal = sunDirection;
    sum += BETWEEN_LEAVES * sunLight(r, s);
#endif
    return min(sum, vec3(MAX_RADIANCE));
}

// ahead: towards the eye. The shadow is that of a place outside of the billboard on the sun's side, so that it is not in
// its own.
vec3 lightOf(Billboard b, int number, vec3 fromMiddle, vec3 middle, BillboardAxes axes, vec3 ahead, float width) {
    Surface s;
    s.baseColour = vec3(1.0);
    s.normal = normalize(ahead + BULGE * (corner.x * axes.right + corner.y * axes.up));
    s.faceNormal = s.normal;
#ifdef ANCHOR_POSITION
    vec3 outside = vec3(0.0);
#ifdef SUN
    outside = 0.6 * width * normalize(vec3(sunDirection.x, 1e-4, sunDirection.z));
#endif
    s.anchorPosition = b.foot + middle + 0.9 * fromMiddle + outside;
#endif
#ifdef SKY_AMBIENT
    s.skyVisibility = b.sky;
#endif
#ifdef BOUNCED_LIGHT
    s.bounced = texelFetch(bouncedLight, number).rgb;
#endif
    return lightAt(s);
}

void main() {
    int number = billboardNumber();
    if (number < 0) {
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
        return;
    }
    Billboard b = billboardAt(number);
    vec4 shape = billboardGroup(b.group, 0);
    vec2 size = shape.xy * b.scale;
    vec3 middle = vec3(0.0, 0.5 * size.y, 0.0);
    vec3 relative = (b.foot - eyeHigh) - eyeLow + middle;
#ifdef OBSERVER
    BillboardAxes axes = observedAxes(int(shape.z), observer - b.foot - middle, b.turn);
#else
    BillboardAxes axes =
            facingAxes(int(shape.z), -relative, normalize(viewRight.xyz), normalize(viewUp.xyz), b.turn);
#endif
    vec3 fromMiddle = cornerFromMiddle(axes, size, swayMetres(billboardGroup(b.group, 2), b, size.y));
    vec3 position = relative + fromMiddle;

#ifdef SURFACES
    fadeMetres = FADE_SHARE * size.x;
#endif

    vec4 frames = billboardGroup(b.group, 1);
    float frame = billboardFrame(frames, b);
    float whole = min(floor(frame), frames.y - 1.0);
    float next = whole + 1.0 < frames.y ? whole + 1.0 : 0.0;
    layers = vec3(shape.w + whole, shape.w + next, frame - whole);
    st = vec2(0.5 + 0.5 * corner.x, 0.5 - 0.5 * corner.y);
    oneColour = billboardGroup(b.group, 3);

    vec3 front = cross(axes.right, axes.up);
    vec3 ahead = dot(front, relative) > 0.0 ? -front : front;
#ifdef PUNCTUAL_LIGHTS
    lampPlace = b.foot + middle + 0.9 * fromMiddle;
    toFront = ahead;
    bulgeRight = BULGE * axes.right;
    bulgeUp = BULGE * axes.up;
#endif
    litRadiance = lightOf(b, number, fromMiddle, middle, axes, ahead, size.x) + billboardGroup(b.group, 4).rgb;
    addedRadiance = vec3(0.0);
    passing = 1.0;
#ifdef AIR
    Air air = airAlong(relative);
    airPassing = air.transmittance;
    addedRadiance = air.inScatter;
#endif
#ifdef FOG
    passing = throughFog(relative);
    addedRadiance = mix(fog.rgb, addedRadiance, passing);
#endif
    clipToView(position);
    gl_Position = clipFromRelative * vec4(position, 1.0);
}
