// The lamps of a level and which of them a place has to ask. Packed by nephele.engine.scene.light.LampTable.
// Needs lamp-falloff.glsl and light.glsl.

uniform samplerBuffer lampTexels;      // four texels a lamp
uniform usamplerBuffer lampGridCells;  // start of each list, seven a cell, then the lists

struct Lamp {
    vec4 position;   // metres from the anchor; w: 1 / range^2
    vec4 intensity;  // w: cone scale
    vec4 axis;       // w: cone offset
    vec4 shadow;     // right axis of the depth picture times its cotangent; w: layer, -1 without
};

Lamp lampAt(int index) {
    int texel = 4 * index;
    return Lamp(
            texelFetch(lampTexels, texel),
            texelFetch(lampTexels, texel + 1),
            texelFetch(lampTexels, texel + 2),
            texelFetch(lampTexels, texel + 3));
}

// Faces that look along +x -x +y -y +z -z have lists of their own, without the lamps behind them; 6: the rest.
int facingOf(vec3 faceNormal) {
    vec3 along = step(0.9999, abs(faceNormal));
    float axis = dot(along, vec3(1.0, 2.0, 3.0));
    float side = dot(faceNormal, along) < 0.0 ? 1.0 : 0.0;
    return axis > 0.0 ? int(2.0 * axis - 2.0 + side) : 6;
}

// First and one past the last entry of a face's list.
ivec2 lampListAt(vec3 anchorPosition, vec3 faceNormal) {
    vec3 cell = (anchorPosition - lampGridMin) * lampGridCellsPerMetre;
    ivec3 c = ivec3(clamp(cell, vec3(0.0), lampGridSize - 0.5));
    ivec2 size = ivec2(lampGridSize.xy);
    int at = 7 * (c.x + size.x * (c.y + size.y * c.z)) + facingOf(faceNormal);
    return ivec2(int(texelFetch(lampGridCells, at).x), int(texelFetch(lampGridCells, at + 1).x));
}

int lampOfEntry(int entry) {
    return int(texelFetch(lampGridCells, entry).x);
}

// Irradiance on a plane perpendicular to the light, without shadow.
vec3 lampIrradiance(Lamp lamp, vec3 toLamp, float squareDistance) {
    float cosine = -dot(toLamp, lamp.axis.xyz);
    return lamp.intensity.rgb
            * (windowedInverseSquare(squareDistance, lamp.position.w)
                    * coneFactor(cosine, lamp.intensity.w, lamp.axis.w));
}
