// Log2 of the mean luminance of each cell of the picture. Twin: level.appearance.LuminanceHistogram.

uniform sampler2D linearPicture; // alpha: the share of the pixel that is metered

layout(location = 0) out vec4 cell; // x: log2 luminance

// Less than one is hidden: display values that were drawn into the scene. The slack is three steps of a half float.
const float LEAST_SHARE = 0.9985;
const float LARGEST_HALF = java(level.appearance.LuminanceHistogram.LARGEST_HALF);

// The centre of a sample, in whole numbers, so that no rounding decides between two pixels.
ivec2 pixelOf(int index) {
    ivec2 samples = ivec2(COLUMNS, ROWS) * SAMPLES;
    ivec2 at = ivec2(gl_FragCoord.xy) * SAMPLES + ivec2(index % SAMPLES, index / SAMPLES);
    return (2 * at + 1) * textureSize(linearPicture, 0) / (2 * samples);
}

void main() {
    float sum = 0.0;
    float counted = 0.0;
    for (int i = 0; i < SAMPLES * SAMPLES; i++) {
        vec4 radiance = texelFetch(linearPicture, pixelOf(i), 0);
        float luminance = dot(radiance.rgb, vec3(0.2126, 0.7152, 0.0722));
        // False for NaN.
        bool isFinite = luminance >= -LARGEST_HALF && luminance <= LARGEST_HALF;
        if (isFinite && radiance.a >= LEAST_SHARE) {
            sum += max(luminance, 0.0);
            counted += 1.0;
        }
    }
    float mean = sum / max(counted, 1.0);
    cell = vec4(counted == 0.0 ? HIDDEN : mean < exp2(DARKEST_LOG2) ? BLACK : log2(mean), 0.0, 0.0, 1.0);
}
