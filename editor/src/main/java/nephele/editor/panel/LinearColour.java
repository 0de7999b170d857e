package nephele.editor.panel;

import java.awt.Color;
import nephele.engine.math.Vec3;

/** Converts linear RGB to and from the sRGB of the screen (IEC 61966-2-1). */
final class LinearColour {
    private LinearColour() {}

    /** Returns the colour on the screen; one that is brighter than white keeps its hue. */
    static Color onScreen(Vec3 linear) {
        Vec3 scaled = linear.scaled(1 / Math.max(1, greatest(linear)));
        return new Color(encoded(scaled.x()), encoded(scaled.y()), encoded(scaled.z()));
    }

    static double greatest(Vec3 linear) {
        return Math.max(linear.x(), Math.max(linear.y(), linear.z()));
    }

    static Vec3 linear(Color colour) {
        return new Vec3(decoded(colour.getRed()), decoded(colour.getGreen()), decoded(colour.getBlue()));
    }

    private static float encoded(double linear) {
        double in = Math.max(0, Math.min(1, linear));
        return (float) Math.min(1, in <= 0.0031308 ? 12.92 * in : 1.055 * Math.pow(in, 1 / 2.4) - 0.055);
    }

    private static double decoded(int byteValue) {
        double in = byteValue / 255.0;
        return in <= 0.04045 ? in / 12.92 : Math.pow((in + 0.055) / 1.055, 2.4);
    }
}
