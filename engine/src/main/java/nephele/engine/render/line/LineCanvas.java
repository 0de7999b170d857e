package nephele.engine.render.line;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.DisplayColour;
import org.joml.Vector3d;
import org.joml.Vector4d;

/** Collects lines, polygons and squares of one picture as triangles; fill it before each draw. */
public final class LineCanvas {
    /** x, y, z from −1 to 1; red, green, blue, alpha; pixels from the line's axis; half the line's width in pixels. */
    static final int FLOATS_PER_VERTEX = 9;

    /** Lines are cut this far outside the picture. */
    private static final double MARGIN_PIXELS = 16;

    /** The distance of an axis that fills a whole polygon. */
    private static final double[] FILLED = {0, 1};

    private final Map<LineLayer, Vertices> layers = new EnumMap<>(LineLayer.class);
    private LineProjection projection;

    /** Creates an empty canvas. */
    public LineCanvas() {
        for (LineLayer layer : LineLayer.values()) {
            layers.put(layer, new Vertices());
        }
    }

    /** Vertices in drawing order. */
    static final class Vertices {
        private float[] floats = new float[64 * FLOATS_PER_VERTEX];
        private int length;

        float[] floats() {
            return floats;
        }

        int length() {
            return length;
        }

        private void add(double[] xyz, DisplayColour colour, double across, double halfWidth) {
            if (length == floats.length) {
                floats = Arrays.copyOf(floats, 2 * length);
            }
            float[] values = {
                (float) xyz[0],
                (float) xyz[1],
                (float) xyz[2],
                colour.red(),
                colour.green(),
                colour.blue(),
                colour.alpha(),
                (float) across,
                (float) halfWidth
            };
            System.arraycopy(values, 0, floats, length, values.length);
            length += values.length;
        }
    }

    /** Empties the canvas. */
    public void begin(LineProjection of) {
        projection = of;
        layers.values().forEach(vertices -> vertices.length = 0);
    }

    /** Returns true if nothing is visible. */
    public boolean isEmpty() {
        return layers.values().stream().allMatch(vertices -> vertices.length == 0);
    }

    /** Adds a line between two points of the world. */
    public void line(Vec3 from, Vec3 to, DisplayColour colour, double widthPixels, LineLayer layer) {
        Vector4d a = projection.clip(from);
        Vector4d b = projection.clip(to);
        double beforeA = a.z + a.w;
        double beforeB = b.z + b.w;
        if (beforeA < 0 && beforeB < 0) {
            return;
        }
        Vector4d start = beforeA < 0 ? between(a, b, beforeA / (beforeA - beforeB)) : a;
        Vector4d end = beforeB < 0 ? between(a, b, beforeA / (beforeA - beforeB)) : b;
        line(pixel(start), pixel(end), colour, widthPixels, layer);
    }

    /**
     * Adds a line between two places of the picture, in pixels from the upper left corner. Pixel centres are at halves.
     */
    public void screenLine(double[] fromXy, double[] toXy, DisplayColour colour, double widthPixels) {
        Vector3d from = new Vector3d(fromXy[0], projection.height() - fromXy[1], 0);
        Vector3d to = new Vector3d(toXy[0], projection.height() - toXy[1], 0);
        line(from, to, colour, widthPixels, LineLayer.OVER_ALL);
    }

    /** Adds a filled convex polygon of the world; its corners are in order around it. */
    public void polygon(List<Vec3> corners, DisplayColour colour, LineLayer layer) {
        List<Vector4d> visible = inFront(corners);
        Vertices vertices = layers.get(layer);
        for (int i = 2; i < visible.size(); i++) {
            for (Vector4d corner : List.of(visible.get(0), visible.get(i - 1), visible.get(i))) {
                vertices.add(scaled(pixel(corner)), colour, FILLED[0], FILLED[1]);
            }
        }
    }

    /** Adds a filled square around a point of the world, over everything; nothing if the point is behind the eye. */
    public void square(Vec3 at, double sizePixels, DisplayColour colour) {
        Vector4d clip = projection.clip(at);
        if (clip.z + clip.w < 0) {
            return;
        }
        Vector3d middle = pixel(clip);
        double half = sizePixels / 2;
        Vector3d left = new Vector3d(middle.x - half, middle.y, middle.z);
        Vector3d right = new Vector3d(middle.x + half, middle.y, middle.z);
        quad(left, right, colour, new double[] {half, 1e3}, LineLayer.OVER_ALL);
    }

    Vertices vertices(LineLayer layer) {
        return layers.get(layer);
    }

    private List<Vector4d> inFront(List<Vec3> corners) {
        List<Vector4d> clipped = new ArrayList<>(corners.size() + 1);
        for (int i = 0; i < corners.size(); i++) {
            Vector4d a = projection.clip(corners.get(i));
            Vector4d b = projection.clip(corners.get((i + 1) % corners.size()));
            double beforeA = a.z + a.w;
            double beforeB = b.z + b.w;
            if (beforeA >= 0) {
                clipped.add(a);
            }
            if (beforeA < 0 != beforeB < 0) {
                clipped.add(between(a, b, beforeA / (beforeA - beforeB)));
            }
        }
        return clipped;
    }

    private static Vector4d between(Vector4d a, Vector4d b, double fraction) {
        return new Vector4d(b).sub(a).mul(fraction).add(a);
    }

    /** Returns a point of the picture in pixels from the lower left corner, with its depth. */
    private Vector3d pixel(Vector4d clip) {
        return new Vector3d(projection.pixelX(clip), projection.pixelY(clip), projection.depth(clip));
    }

    private void line(Vector3d from, Vector3d to, DisplayColour colour, double widthPixels, LineLayer layer) {
        double[] ends = insidePicture(from, to);
        double length = Math.hypot(to.x - from.x, to.y - from.y);
        if (ends[0] > ends[1] || !(length > 1e-9)) {
            return;
        }
        double half = widthPixels / 2;
        double cap = half / length;
        Vector3d start = from.lerp(to, ends[0] - cap, new Vector3d());
        Vector3d end = from.lerp(to, ends[1] + cap, new Vector3d());
        quad(start, end, colour, new double[] {half + 0.5, half}, layer);
    }

    /** Returns the fractions at which a line enters and leaves the picture and its margin (Liang and Barsky 1984). */
    private double[] insidePicture(Vector3d from, Vector3d to) {
        double[] ends = {0, 1};
        limit(ends, from.x, to.x - from.x, projection.width());
        limit(ends, from.y, to.y - from.y, projection.height());
        return ends;
    }

    private static void limit(double[] ends, double from, double change, double size) {
        double toLeast = -MARGIN_PIXELS - from;
        double toMost = size + MARGIN_PIXELS - from;
        if (change == 0) {
            ends[1] = toLeast > 0 || toMost < 0 ? -1 : ends[1];
            return;
        }
        double entry = Math.min(toLeast / change, toMost / change);
        double exit = Math.max(toLeast / change, toMost / change);
        ends[0] = Math.max(ends[0], entry);
        ends[1] = Math.min(ends[1], exit);
    }

    /** @param halves half the drawn width, half the width that is opaque */
    private void quad(Vector3d from, Vector3d to, DisplayColour colour, double[] halves, LineLayer layer) {
        double length = Math.hypot(to.x - from.x, to.y - from.y);
        double sideX = -(to.y - from.y) / length * halves[0];
        double sideY = (to.x - from.x) / length * halves[0];
        double[][] corners = {
            scaled(new Vector3d(from.x + sideX, from.y + sideY, from.z)),
            scaled(new Vector3d(from.x - sideX, from.y - sideY, from.z)),
            scaled(new Vector3d(to.x - sideX, to.y - sideY, to.z)),
            scaled(new Vector3d(to.x + sideX, to.y + sideY, to.z))
        };
        Vertices vertices = layers.get(layer);
        for (int corner : new int[] {0, 1, 2, 2, 3, 0}) {
            boolean isLeft = corner == 0 || corner == 3;
            vertices.add(corners[corner], colour, isLeft ? halves[0] : -halves[0], halves[1]);
        }
    }

    private double[] scaled(Vector3d pixel) {
        return new double[] {2 * pixel.x / projection.width() - 1, 2 * pixel.y / projection.height() - 1, pixel.z};
    }
}
