// Light of a flash of lightning in a cloud. Some points of the bolt light it; between a point and a place the light is
// scattered so often that it arrives from all sides: the fluence is that of the light alone, twice near the surface of a
// conservative medium, and falls with the transport optical depth between them as the transmittance of a slab does,
// 1 / (1 + 3/4 (1 - g) tau) (Bohren 1987, "Multiple scattering of light and some of its observable consequences", equation 14).
uniform vec4 flashLights[FLASH_LIGHTS]; // xyz: from the eye, metres; w: share of the intensity
uniform vec3 flashIntensity; // radiant, of the whole bolt

const float FLASH_SOFTENING = 120.0 * 120.0; // square of half the length of channel that a point stands for, metres
const float FLASH_SURFACE = 2.0;

float cellsNear(vec3 place) {
    return cellDensity(textureLod(cloudDensity, texelOf(place, place.y, boxOf(place).x, cells.x), 0.0));
}

// Light scattered at a place into any direction, per optical depth and radiant intensity.
float flashedAt(vec3 place, float density) {
    float transport = 0.75 * medium.x * medium.y * (1.0 - phase.x);
    float sum = 0.0;
    for (int i = 0; i < FLASH_LIGHTS; i++) {
        vec3 towards = flashLights[i].xyz - place;
        float square = dot(towards, towards);
        float between = 0.34 * density + 0.33 * (cellsNear(place + 0.3 * towards) + cellsNear(place + 0.7 * towards));
        float resistance = 1.0 + transport * between * sqrt(square);
        sum += flashLights[i].w / ((square + FLASH_SOFTENING) * resistance);
    }
    return medium.z * FLASH_SURFACE / FOUR_PI * sum;
}

// Adds a part of a ray behind those before it.
void addFlashed(inout CloudRay ray, vec3 place, float density, float depth, float metres) {
    float taken = ray.scaled * takenBy(medium.y * depth);
    ray.sunlight += taken * flashedAt(place, density);
    ray.metres += taken * metres;
    ray.scaled -= taken;
    ray.transmittance *= exp(-depth);
}
