package nephele.app.command;

import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Collectors;
import nephele.app.window.Size;
import nephele.engine.asset.FileName;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.reference.tile.Shard;
import nephele.engine.render.frame.Output;
import nephele.host.compare.TechniquePair;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** How the words of a command line become values: numbers separated by commas, words of a set, paths. */
final class OptionValues {
    /** The greatest magnitude of a level's coordinates and angles, in metres or degrees. */
    static final double MOST = 1e7;

    private OptionValues() {}

    /** Registers the types that options of several commands have. */
    static void register(CommandLine commandLine) {
        commandLine
                .registerConverter(Path.class, OptionValues::path)
                .registerConverter(Output.class, word(EnumSet.allOf(Output.class)))
                .registerConverter(ReferenceOptions.Switch.class, word(EnumSet.allOf(ReferenceOptions.Switch.class)))
                .registerConverter(CloudTechnique.class, word(EnumSet.allOf(CloudTechnique.class)))
                .registerConverter(Vec3.class, OptionValues::point)
                .registerConverter(PlayerStart.class, OptionValues::start)
                .registerConverter(Size.class, parsed(Size::parse))
                .registerConverter(Shard.class, parsed(Shard::parse))
                .registerConverter(TechniquePair.class, parsed(TechniquePair::parse));
    }

    /** @param parse throws an illegal argument with a sentence about what is wrong */
    private static <T> ITypeConverter<T> parsed(Function<String, T> parse) {
        return text -> {
            try {
                return parse.apply(text);
            } catch (IllegalArgumentException wrong) {
                throw new TypeConversionException(wrong.getMessage());
            }
        };
    }

    /** Returns what reads one of these words, ignoring case; messages list them in lower case. */
    static <E extends Enum<E>> ITypeConverter<E> word(EnumSet<E> words) {
        return text -> words.stream()
                .filter(word -> word.name().equalsIgnoreCase(text))
                .findFirst()
                .orElseThrow(() -> new TypeConversionException("'" + text + "' is none of "
                        + words.stream()
                                .map(word -> word.name().toLowerCase(Locale.ROOT))
                                .collect(Collectors.joining(", "))));
    }

    private static Path path(String typed) {
        String objection = FileName.objection(typed);
        if (objection != null) {
            throw new TypeConversionException(FileName.printable(typed) + ": " + objection);
        }
        return Path.of(typed);
    }

    private static double[] numbers(String text, String pattern) {
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
    private static Vec3 point(String text) {
        double[] numbers = numbers(text, "x,y,z");
        return new Vec3(numbers[0], numbers[1], numbers[2]);
    }

    /** Reads {@code x,y,z,yawDeg,pitchDeg}. */
    private static PlayerStart start(String text) {
        double[] numbers = numbers(text, "x,y,z,yawDeg,pitchDeg");
        if (Math.abs(numbers[4]) > 90) {
            throw new TypeConversionException("'" + text + "' must have a pitchDeg from -90 to 90");
        }
        return new PlayerStart(new Vec3(numbers[0], numbers[1], numbers[2]), numbers[3], numbers[4]);
    }
}
