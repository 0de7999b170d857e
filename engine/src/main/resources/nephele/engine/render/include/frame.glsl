// What every shader knows of the view; written by render.frame.FrameUniforms.
// "Relative" space: world directions, origin at the eye, metres.
layout(std140) uniform Frame {
    mat4 clipFromRelative;
    vec4 viewRight; // times the tangent of half the horizontal field of view
    vec4 viewUp; // times the tangent of half the vertical field of view
    vec4 viewForward; // w: -1 in a mirrored view, else 1
    vec4 development; // x: exposure factor
    vec4 viewClip; // of a view through an opening: normal and distance of the eye from the plane it is cut by
    vec4 fog; // rgb: radiance, a: extinction per metre
    vec4 mirrorTint; // rgb: what the mirrors before the view multiply radiance by
};
