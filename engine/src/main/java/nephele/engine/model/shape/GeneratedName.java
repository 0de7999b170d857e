package nephele.engine.model.shape;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.model.ModelFileException;

/**
 * Parses file names that describe how their mesh is generated: {@code sphere_1_8_8.3d} is the generator's {@code sphere
 * 1 8 8}, {@code bezier_10.3d} the teapot at tessellation 10.
 */
public final class GeneratedName {
    private static final String PATCHES = "teapot.patch";
    private static final Pattern NAME = Pattern.compile(
            "(?:.*[/\\\\])?(plane|box|cone|sphere|cylinder|torus|bezier)((?:_[0-9][0-9.]{0,15}){1,4})\\.3d");

    private GeneratedName() {}

    /**
     * Returns the shape that a name describes; empty for other names.
     *
     * @param neighbour returns the bytes of a file in the same folder, {@code null} if there is none; a teapot.patch
     *     there overrides the one that ships
     * @throws ModelFileException if the name has the generator's form but invalid numbers
     */
    public static Optional<Shape> shape(String fileName, Function<String, byte[]> neighbour) {
        Matcher matcher = NAME.matcher(fileName);
        if (!matcher.matches()) {
            return Optional.empty();
        }
        List<String> numbers = List.of(matcher.group(2).substring(1).split("_"));
        try {
            return Optional.of(
                    ShapeKind.named(matcher.group(1)).isPresent()
                            ? ShapeKind.named(matcher.group(1)).get().shape(numbers)
                            : teapot(numbers, neighbour));
        } catch (IllegalArgumentException problem) {
            throw new ModelFileException(
                    fileName, 0, problem.getMessage(), "correct the name, or put the file there", problem);
        }
    }

    private static Shape teapot(List<String> numbers, Function<String, byte[]> neighbour) {
        if (numbers.size() != 1) {
            throw new IllegalArgumentException("bezier takes 1 number (TESSELLATION), not " + numbers.size());
        }
        int tessellation = (int) ShapeParameter.TESSELLATION.read(numbers.get(0));
        byte[] own = neighbour.apply(PATCHES);
        byte[] bytes = own != null ? own : new ResourceAssets("/assets").bytes(BezierPatches.SHIPPED);
        return new BezierShape(BezierPatches.read(PATCHES, bytes), tessellation);
    }
}
