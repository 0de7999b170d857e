// The punctual lights of a level and the lists of those that can reach a place. Packed by
// nephele.engine.scene.light.PunctualLightTable. Needs light-falloff.glsl and light.glsl.

uniform samplerBuffer lightTexels;      // four texels for each light
uniform usamplerBuffer lightGridCells;  // start of each list, seven for each cell, then the lists

struct PunctualLight {
    vec4 position;   // metres from the anchor; w: 1 / range^2
    vec4 intensity;  // w: cone scale
    vec4 axis;       // w: cone offset
    vec4 shadow;     // right axis of the depth picture times its cotangent; w: layer, -1 for none
};

PunctualLight lightAt(int index) {
    int texel = 4 * index;
    return PunctualLight(
            texelFetch(lightTexels, texel),
            texelFetch(lightTexels, texel + 1),
            texelFetch(lightTexels, texel + 2),
            texelFetch(lightTexels, texel + 3));
}

// Faces along +x -x +y -y +z -z have lists of their own, without the lights behind them; 6: all others.
int facingOf(vec3 faceNormal) {
    vec3 along = step(0.9999, abs(faceNormal));
    float axis = dot(along, vec3(1.0, 2.0, 3.0));
    float side = dot(faceNormal, along) < 0.0 ? 1.0 : 0.0;
    return axis > 0.0 ? int(2.0 * axis - 2.0 + side) : 6;
}

// Returns the first and one past the last entry of a face's list.
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

// Returns the irradiance on a plane perpendicular to the light, without shadow.
vec3 lightIrradiance(PunctualLight punctualLight, vec3 towardsLight, float squareDistance) {
    float cosine = -dot(towardsLight, punctualLight.axis.xyz);
    return punctualLight.intensity.rgb
            * (windowedInverseSquare(squareDistance, punctualLight.position.w)
                    * coneFactor(cosine, punctualLight.intensity.w, punctualLight.axis.w));
}
