layout(location = 0) in vec3 direction;
layout(location = 1) in vec3 colour;
layout(location = 2) in vec2 fromEnd; // pixels

uniform mat4 clipFromRelative;
uniform vec3 clipPerPixel; // z: length of an axis, pixels

flat out vec3 axisColour;

const vec2 FROM_CORNER = vec2(56.0, 56.0); // pixels

void main() {
    axisColour = colour;
    mat4 rows = transpose(clipFromRelative);
    vec2 onScreen = vec2(dot(normalize(rows[0].xyz), direction), dot(normalize(rows[1].xyz), direction));
    vec2 pixels = onScreen * clipPerPixel.z + fromEnd - FROM_CORNER;
    gl_Position = vec4(1.0 + pixels * clipPerPixel.xy, 0.0, 1.0);
}
