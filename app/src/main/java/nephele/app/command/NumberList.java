package nephele.app.command;

import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import picocli.CommandLine.TypeConversionException;

/** Parses numbers separated by commas, each in the range that a level's coordinates and angles have. */
final class NumberList {
    /** The greatest magnitude, in metres or degrees. */
    static final double MOST = 1e7;

    private NumberList() {}

    private static double[] read(String text, String pattern) {
        String[] parts = text.split(",", -1);
        double[] numbers = new double[parts.length];
        for (int i = 0; i < parts.length; i++) {
            numbers[i] = OptionRange.number(parts[i]);
            if (!(Math.abs(numbers[i]) <= MOST)) {
                throw wrong(text, pattern);
            }
        }
        if (numbers.length != pattern.split(",").length) {
            throw wrong(text, pattern);
        }
        return numbers;
    }

    private static TypeConversionException wrong(String text, String pattern) {
        return new TypeConversionException("'" + text + "' must be numbers like this: " + pattern + ", each from -"
                + OptionRange.text(MOST) + " to " + OptionRange.text(MOST));
    }

    /** Reads {@code x,y,z}. */
    static Vec3 point(String text) {
        double[] numbers = read(text, "x,y,z");
        return new Vec3(numbers[0], numbers[1], numbers[2]);
    }

    /** Reads {@code x,y,z,yawDeg,pitchDeg}. */
    static PlayerStart start(String text) {
        double[] numbers = read(text, "x,y,z,yawDeg,pitchDeg");
        if (Math.abs(numbers[4]) > 90) {
            throw new TypeConversionException("'" + text + "' must have a pitchDeg from -90 to 90");
        }
        return new PlayerStart(new Vec3(numbers[0], numbers[1], numbers[2]), numbers[3], numbers[4]);
    }
}
