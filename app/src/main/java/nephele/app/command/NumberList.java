package nephele.app.command;

import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Parses numbers separated by commas, each in the range that a level's coordinates and angles have. */
final class NumberList {
    /** The greatest magnitude, in metres or degrees. */
    static final double MOST = 1e7;

    private NumberList() {}

    static double[] read(String text, String pattern) {
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

    /** Reads `x,y,z`. */
    static final class PointConverter implements ITypeConverter<Vec3> {
        @Override
        public Vec3 convert(String text) {
            double[] numbers = read(text, "x,y,z");
            return new Vec3(numbers[0], numbers[1], numbers[2]);
        }
    }

    /** Reads `x,y,z,yawDeg,pitchDeg`. */
    static final class StartConverter implements ITypeConverter<PlayerStart> {
        @Override
        public PlayerStart convert(String text) {
            double[] numbers = read(text, "x,y,z,yawDeg,pitchDeg");
            if (Math.abs(numbers[4]) > 90) {
                throw new TypeConversionException("'" + text + "' must have a pitchDeg from -90 to 90");
            }
            var feet = new Vec3(numbers[0], numbers[1], numbers[2]);
            return new PlayerStart(feet, numbers[3], numbers[4]);
        }
    }
}
