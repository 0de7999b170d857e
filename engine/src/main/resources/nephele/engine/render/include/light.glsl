// The numbers of a level's light in this frame; written by render.resource.LightBlock.
layout(std140) uniform Light {
    vec3 sunDirection; // towards the sun, unit
    vec3 sunIrradiance; // on a perpendicular plane
    vec3 ambientRadiance;
    mat4 sunMapFromAnchor; // metres from the anchor -> texture coordinates and depth, 0 to 1
    vec4 sunMapRight; // unit axis along the map's rows; w: texel side / depth range
    vec4 sunMapUp; // unit axis along its columns; w: half a texel side / depth range
    vec3 lightGridMin; // metres from the anchor
    vec3 lightGridCellsPerMetre;
    vec3 lightGridSize;
    vec3 cloudShadeMin; // metres from the anchor
    vec3 cloudShadePerMetre; // 1 / size of the region of cloudShade
    vec3 skyCoefficients[9]; // 1, y, z, x, xy, yz, 3z^2 - 1, xz, x^2 - y^2
    vec3 lightParts; // shares of ambient, diffuse and specular light that are shown; 1, unless LIGHT_PARTS is defined
#ifdef FLASH
    vec4 flashPlace; // xyz: of the bolt's middle, metres from the anchor; w: square that softens the light near it
    vec3 flashIntensity; // radiant; zero between flashes
    vec3 flashGlow; // irradiance from lit clouds on a surface that faces upwards
#endif
};
