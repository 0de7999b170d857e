package nephele.app.command;

import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Parses finite numbers separated by commas. */
final class NumberList {
    private NumberList() {}

    static double[] read(String text, String pattern) {
        String[] parts = text.split(",", -1);
        double[] numbers = new double[parts.length];
        try {
            for (int i = 0; i < parts.length; i++) {
                numbers[i] = Double.parseDouble(parts[i]);
            }
        } catch (NumberFormatException notNumbers) {
            throw wrong(text, pattern);
        }
        for (double number : numbers) {
            if (!Double.isFinite(number)) {
                throw wrong(text, pattern);
            }
        }
        if (numbers.length != pattern.split(",").length) {
            throw wrong(text, pattern);
        }
        return numbers;
    }

    private static TypeConversionException wrong(String text, String pattern) {
        return new TypeConversionException("'" + text + "' must be finite numbers like this: " + pattern);
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
            var feet = new Vec3(numbers[0], numbers[1], numbers[2]);
            return new PlayerStart(feet, numbers[3], numbers[4]);
        }
    }
}
