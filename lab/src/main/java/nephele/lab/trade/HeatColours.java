package nephele.lab.trade;

import java.util.Arrays;
import java.util.stream.Collectors;

/**
 * A colour map for errors, of growing lightness: black, violet, red, orange, cream. It is readable without colour
 * vision.
 */
final class HeatColours {
    /** Red, green, blue at even steps of error from 0 to 1. */
    private static final int[][] STOPS = {
        {0, 0, 4}, {40, 17, 90}, {114, 31, 129}, {183, 55, 121}, {240, 96, 93}, {254, 176, 120}, {252, 253, 191}
    };

    private HeatColours() {}

    /** @param error clamped to 0–1 */
    static int of(double error) {
        double at = Math.min(Math.max(error, 0), 1) * (STOPS.length - 1);
        int stop = Math.min((int) at, STOPS.length - 2);
        int colour = 0;
        for (int channel = 0; channel < 3; channel++) {
            double low = STOPS[stop][channel];
            double high = STOPS[stop + 1][channel];
            colour = colour << 8 | (int) Math.rint(low + (at - stop) * (high - low));
        }
        return colour;
    }

    /** Returns the stops of a CSS gradient, from 0 to 1. */
    static String gradient() {
        return Arrays.stream(STOPS)
                .map(stop -> "rgb(" + stop[0] + "," + stop[1] + "," + stop[2] + ")")
                .collect(Collectors.joining(","));
    }
}
