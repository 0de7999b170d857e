package nephele.engine.model.shape;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.model.ModelText;
import org.joml.Vector3d;

/**
 * A surface of bicubic patches, as stored in a {@code .patch} file.
 *
 * @param file name of the file, for errors
 */
public record BezierPatches(String file, List<BezierPatch> patches) {
    private static final int MOST_PATCHES = 100_000;
    private static final int MOST_POINTS = 1_000_000;
    private static final int CORNERS = BezierPatch.SIDE * BezierPatch.SIDE;

    public static final String SHIPPED = "models/teapot.patch";

    /**
     * Reads a {@code .patch} file: the number of patches, 16 indices a line, the number of points, a point a line.
     *
     * @param file its name, for errors
     * @throws nephele.engine.model.ModelFileException if the file is malformed
     */
    public static BezierPatches read(String file, byte[] bytes) {
        ModelText text = new ModelText(file, bytes, ",");
        List<Integer> lines = new ArrayList<>();
        List<int[]> indices = indices(text, lines);
        Vector3d[] points = points(text);
        while (text.hasNext()) {
            if (!text.nextLine().isEmpty()) {
                throw text.error("something follows the last point", "correct the number of points, or delete it");
            }
        }
        List<BezierPatch> patches = new ArrayList<>();
        for (int i = 0; i < indices.size(); i++) {
            patches.add(patch(text, indices.get(i), lines.get(i), points));
        }
        return new BezierPatches(file, List.copyOf(patches));
    }

    /** @param lines receives the line of each patch's indices, for later errors */
    private static List<int[]> indices(ModelText text, List<Integer> lines) {
        int count = count(text, "patches", MOST_PATCHES);
        List<int[]> indices = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            List<String> words = words(text, "patch " + (i + 1) + " of " + count, CORNERS, "indices");
            indices.add(words.stream().mapToInt(text::whole).toArray());
            lines.add(text.line());
        }
        return indices;
    }

    private static Vector3d[] points(ModelText text) {
        int count = count(text, "points", MOST_POINTS);
        List<Vector3d> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            List<String> words = words(text, "point " + i + " of " + count, 3, "coordinates");
            points.add(new Vector3d(
                    text.coordinate(words.get(0)), text.coordinate(words.get(1)), text.coordinate(words.get(2))));
        }
        return points.toArray(new Vector3d[0]);
    }

    private static BezierPatch patch(ModelText text, int[] indices, int line, Vector3d[] points) {
        Vector3d[] corners = new Vector3d[CORNERS];
        for (int i = 0; i < CORNERS; i++) {
            if (indices[i] < 0 || indices[i] >= points.length) {
                throw text.wrongAt(
                        line,
                        "index " + indices[i] + " names no point",
                        "use 0 to " + (points.length - 1) + ", as there are " + points.length + " points");
            }
            corners[i] = points[indices[i]];
        }
        return new BezierPatch(corners);
    }

    private static int count(ModelText text, String what, int most) {
        int count = text.whole(words(text, "the number of " + what, 1, "number").get(0));
        if (count < 1 || count > most) {
            throw text.error("there can't be " + count + " " + what, "write 1 to " + most);
        }
        return count;
    }

    private static List<String> words(ModelText text, String what, int wanted, String unit) {
        while (text.hasNext()) {
            List<String> words = text.nextLine();
            if (words.size() == wanted) {
                return words;
            }
            if (!words.isEmpty()) {
                throw text.error(
                        what + " has " + words.size() + " words in its line",
                        "write " + wanted + " " + unit + " there");
            }
        }
        throw text.error(
                "the file ends before " + what, "write the line that is missing, or correct the number before");
    }
}
