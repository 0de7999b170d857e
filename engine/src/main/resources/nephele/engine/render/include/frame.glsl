// The numbers of a view that all shaders use; written by render.resource.FrameUniforms. "Relative" space: world
// directions, origin at the eye, metres.
layout(std140) uniform Frame {
    mat4 clipFromRelative;
    vec4 viewRight; // times the tangent of half the horizontal field of view; w: shift of the picture, in its halves
    vec4 viewUp; // times the tangent of half the vertical field of view; w: shift of the picture
    vec4 viewForward; // w: -1 in a mirrored view, else 1
    vec4 toneMapping; // x: exposure factor
    vec4 viewClip; // for a view through an opening: normal of its clip plane and the eye's distance from it
    vec4 fog; // rgb: radiance, a: extinction per metre
    vec4 samplePositions[4]; // two in each: from the pixel's centre, pixels
    vec4 mirrorTint; // rgb: product of the tints of the mirrors in front of the view
    vec4 airPlace; // x: height of the eye, metres, y: tan(e / 2) of the horizon's elevation e, z: molecules below the
                   // eye, metres at the density of the ground, w: their density at the eye, relative to that
    vec4 airTowards[2]; // xy: horizontal unit direction towards the sun, then towards the moon, as x and z
    vec4 airIrradiance[2]; // rgb: of the sun and of the moon outside the air, a: 0 where the light does not count
    vec4 fogPlace; // x: height of the eye over the fog's base, in scale heights, y: 1 / scale height, per metre
};

// The direction from the eye that a place of the shifted picture shows, not of unit length; its part along the view's axis
// is 1. corner: from -1 to 1
vec3 shownDirection(vec2 corner) {
    return viewForward.xyz + (corner.x - viewRight.w) * viewRight.xyz + (corner.y - viewUp.w) * viewUp.xyz;
}

// Moves a vertex that was placed in the picture without its shift.
vec4 shifted(vec4 clipPosition) {
    return clipPosition + vec4(viewRight.w, viewUp.w, 0.0, 0.0) * clipPosition.w;
}
