// The materials of a batch; written by render.resource.MaterialBlocks.
struct Material {
    vec4 baseColourRoughness;
    vec4 emissionMetallic;
    vec4 layers; // x: base colour, y: normal map, z: metres covered by one repeat
    vec4 spare;
};

layout(std140) uniform Materials {
    Material materials[MATERIAL_COUNT];
};

Material materialAt(float index) {
#if MATERIAL_COUNT == 1
    return materials[0];
#else
    return materials[int(index)];
#endif
}
