// Exposure from the histogram and from the exposure of the last picture. Twin: level.appearance.AutoExposure.
#include "exposure.glsl"

uniform sampler2D histogram; // number of cells, sum of their steps in the bin; after the bins: hidden cells
uniform vec4 stopsAndShares; // least and greatest stops; shares of the way to more and to fewer stops
uniform float hasHistory; // 0: the texel of the last picture means nothing

layout(location = 0) out vec4 texel; // factor, stops, the stops that the picture calls for

vec2 cellsOf(int bin) {
    return texelFetch(histogram, ivec2(bin, 0), 0).xy;
}

// G. Krawczyk, K. Myszkowski and H.-P. Seidel, "Perceptual Effects in Real-time Tone Mapping", 2005: automatic key.
float key(float log2Luminance) {
    float candelas = CANDELAS_PER_SQUARE_METRE * exp2(log2Luminance);
    return 1.03 - 2.0 / (2.0 + 0.30103 * log2(candelas + 1.0));
}

// The mean of log2 luminance between the two shares of a histogram with this sum.
float meanLog2(float total) {
    float low = LOW_SHARE * total;
    float high = HIGH_SHARE * total;
    float below = 0.0;
    float sum = 0.0;
    for (int bin = 0; bin < int(BINS); bin++) {
        vec2 cells = cellsOf(bin);
        float within = min(below + cells.x, high) - max(below, low);
        if (within > 0.0) {
            sum += within * (DARKEST_LOG2 + (float(bin) + cells.y / (STEPS * cells.x)) / BINS_PER_STOP);
        }
        below += cells.x;
    }
    return sum / (high - low);
}

void main() {
    float last = texelFetch(exposure, ivec2(0), 0).y;
    float total = 0.0;
    for (int bin = 0; bin < int(BINS); bin++) {
        total += cellsOf(bin).x;
    }
    float wanted = stopsAndShares.y;
    if (total > 0.0) {
        float log2Luminance = meanLog2(total);
        wanted = log2(DISPLAYED_PER_KEY * key(log2Luminance)) - log2Luminance;
    } else if (hasHistory > 0.0 && cellsOf(int(BINS)).x > 0.0) {
        wanted = last;
    }
    wanted = clamp(wanted, stopsAndShares.x, stopsAndShares.y);
    float share = wanted > last ? stopsAndShares.z : stopsAndShares.w;
    float stops = hasHistory > 0.0 ? last + share * (wanted - last) : wanted;
    texel = vec4(exp2(stops), stops, wanted, 1.0);
}
