#include "output.glsl"

in vec3 direction;

// Light around the eye by azimuth from the sun and elevation, square roots: scattered once by molecules and once by
// aerosols, without phase functions, then all other light. Per unit solar irradiance.
uniform sampler2DArray skyTable;
uniform vec3 towardsSun;
uniform vec3 irradiance; // of the sun outside the air
uniform vec3 disc; // radiance of the sun's middle
uniform float horizon; // its elevation
uniform float mieG;

const float PI = 3.14159265;
const float SKY_ROWS = 96.0;
const float GROUND_ROWS = 40.0;
const float AZIMUTHS = 48.0;
const float BAND = 0.13962634; // the elevation up to which half of the sky's rows are
const float SUN_SINE = 0.0046530; // of its angular radius

float rowOf(float elevation) {
    float above = elevation - horizon;
    if (above < 0.0) {
        return SKY_ROWS + sqrt(sqrt(min(1.0, -above / (horizon + 0.5 * PI)))) * (GROUND_ROWS - 1.0);
    }
    float band = BAND - horizon;
    float twice = above <= band ? sqrt(above / band) : 1.0 + sqrt(min(1.0, (above - band) / (0.5 * PI - BAND)));
    return 0.5 * twice * (SKY_ROWS - 1.0);
}

vec3 part(vec2 place, float layer) {
    vec3 root = texture(skyTable, vec3(place, layer)).rgb;
    return root * root;
}

float rayleighPhase(float cosine) {
    return 3.0 / (16.0 * PI) * (1.0 + cosine * cosine);
}

// Cornette and Shanks 1992, equation 11; from is 1 + g² − 2g cosine without its cancellation.
float miePhase(float cosine, float fromPeak) {
    float g2 = mieG * mieG;
    float from = (1.0 - mieG) * (1.0 - mieG) + 2.0 * mieG * fromPeak;
    return 3.0 / (8.0 * PI) * (1.0 - g2) * (1.0 + cosine * cosine) / ((2.0 + g2) * from * sqrt(from));
}

void main() {
    vec3 away = normalize(direction);
    float elevation = atan(away.y, length(away.xz));
    vec2 along = vec2(dot(away.xz, towardsSun.xz), away.x * towardsSun.z - away.z * towardsSun.x);
    float azimuth = along == vec2(0.0) ? 0.0 : abs(atan(along.y, along.x));
    vec2 place = vec2(
        (0.5 + azimuth / PI * (AZIMUTHS - 1.0)) / AZIMUTHS,
        (0.5 + rowOf(elevation)) / (SKY_ROWS + GROUND_ROWS));
    vec3 apart = away - towardsSun;
    float fromPeak = 0.5 * dot(apart, apart);
    float cosine = 1.0 - fromPeak;
    vec3 light = rayleighPhase(cosine) * part(place, 0.0) + miePhase(cosine, fromPeak) * part(place, 1.0)
        + part(place, 2.0);
    light *= irradiance;

    // Limb darkening of a grey atmosphere (Eddington's law), with the mean of the disc 1.
    float sine = length(cross(away, towardsSun));
    float pixel = max(fwidth(sine), 1e-6);
    float inside = 1.0 - smoothstep(-0.5, 0.5, (sine - SUN_SINE) / pixel);
    inside *= min(1.0, PI * SUN_SINE * SUN_SINE / (pixel * pixel)); // a disc smaller than a pixel
    if (inside > 0.0 && cosine > 0.0 && elevation > horizon) {
        float fromMiddle = min(1.0, sine / SUN_SINE);
        light += inside * disc * (0.5 + 0.75 * sqrt(1.0 - fromMiddle * fromMiddle));
    }
    writeRadiance(light);
}
