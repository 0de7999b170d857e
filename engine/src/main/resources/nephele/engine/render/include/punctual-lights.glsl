// The lights of a level and which of them a place has to ask. Packed by nephele.engine.scene.light.LightTable.
// Needs light-falloff.glsl and light.glsl.

uniform samplerBuffer lightTexels;      // four texels a light
uniform usamplerBuffer lightGridCells;  // start of each list, seven a cell, then the lists

struct PunctualLight {
    vec4 position;   // metres from the anchor; w: 1 / range^2
    vec4 intensity;  // w: cone scale
    vec4 axis;       // w: cone offset
    vec4 shadow;     // right axis of the depth picture times its cotangent; w: layer, -1 without
};

PunctualLight lightAt(int index) {
    int texel = 4 * index;
    return PunctualLight(
            texelFetch(lightTexels, texel),
            texelFetch(lightTexels, texel + 1),
            texelFetch(lightTexels, texel + 2),
            texelFetch(lightTexels, texel + 3));
}

// Faces that look along +x -x +y -y +z -z have lists of their own, without the lights behind them; 6: the rest.
int facingOf(vec3 faceNormal) {
    vec3 along = step(0.9999, abs(faceNormal));
    float axis = dot(along, vec3(1.0, 2.0, 3.0));
    float side = dot(faceNormal, along) < 0.0 ? 1.0 : 0.0;
    return axis > 0.0 ? int(2.0 * axis - 2.0 + side) : 6;
}

// First and one past the last entry of a face's list.
ivec2 lightListAt(vec3 anchorPosition, vec3 faceNormal) {
    vec3 cell = (anchorPosition - lightGridMin) * lightGridCellsPerMetre;
    ivec3 c = ivec3(clamp(cell, vec3(0.0), lightGridSize - 0.5));
    ivec2 size = ivec2(lightGridSize.xy);
    int at = 7 * (c.x + size.x * (c.y + size.y * c.z)) + facingOf(faceNormal);
    return ivec2(int(texelFetch(lightGridCells, at).x), int(texelFetch(lightGridCells, at + 1).x));
}

int lightOfEntry(int entry) {
    return int(texelFetch(lightGridCells, entry).x);
}

// Irradiance on a plane perpendicular to the light, without shadow.
vec3 lightIrradiance(PunctualLight punctualLight, vec3 towardsLight, float squareDistance) {
    float cosine = -dot(towardsLight, punctualLight.axis.xyz);
    return punctualLight.intensity.rgb
            * (windowedInverseSquare(squareDistance, punctualLight.position.w)
                    * coneFactor(cosine, punctualLight.intensity.w, punctualLight.axis.w));
}
