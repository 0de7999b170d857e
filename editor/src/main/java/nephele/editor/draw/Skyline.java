package nephele.editor.draw;

import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PlanCamera;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;

/**
 * The greatest and the least heights of a height field along a horizontal line of sight, and a section. Where many samples share a
 * pixel, they are those of blocks of cells, so the cost depends on the picture's size more than on the field's.
 */
final class Skyline {
    /** Points of the line are about so many pixels apart where the field has closer samples. */
    private static final double SPACING_PIXELS = 2;

    /** Narrower blocks than this do not exist. */
    private static final int LEAST_BLOCK_CELLS = 4;

    private final PlanCamera camera;
    private final PaneSize size;
    private final HeightField field;
    private final boolean isAlongZ;

    private Skyline(PlanCamera camera, PaneSize size, HeightField field) {
        this.camera = camera;
        this.size = size;
        this.field = field;
        isAlongZ = camera.kind() == PaneKind.FRONT;
    }

    /** The heights at one place across the line of sight. */
    private record Column(double coordinate, double least, double greatest) {}

    /**
     * Adds the greatest heights and those of the section through the camera's centre to {@code major}, the least ones and
     * the two ends to {@code minor}.
     */
    static void add(PlanCamera camera, PaneSize size, HeightField field, PlanSegments minor, PlanSegments major) {
        Skyline lines = new Skyline(camera, size, field);
        lines.add(minor, major);
        lines.addSection(major);
    }

    private void addSection(PlanSegments lines) {
        double half = size.width() / 2.0;
        double before = Double.NaN;
        for (double pixel = -half; pixel <= half + SPACING_PIXELS; pixel += SPACING_PIXELS) {
            double metres = pixel * camera.metresPerPixel();
            double y = isAlongZ
                    ? HeightFieldSurface.y(
                            field, camera.centre().x() + metres, camera.centre().z())
                    : HeightFieldSurface.y(
                            field, camera.centre().x(), camera.centre().z() - metres);
            if (!Double.isNaN(before + y)) {
                lines.add(half + pixel - SPACING_PIXELS, upwards(before), half + pixel, upwards(y));
            }
            before = y;
        }
    }

    private void add(PlanSegments minor, PlanSegments major) {
        double first = isAlongZ ? field.x(0) : field.z(0);
        double cell = isAlongZ ? field.cellX() : field.cellZ();
        int cells = isAlongZ ? field.cellColumns() : field.cellRows();
        double middle = isAlongZ ? camera.centre().x() : camera.centre().z();
        double half = size.width() * camera.metresPerPixel() / 2;
        int from = (int) Math.max(0, Math.floor((middle - half - first) / cell));
        int to = (int) Math.min(cells, Math.ceil((middle + half - first) / cell));
        double together = SPACING_PIXELS * camera.metresPerPixel() / cell;
        boolean isSampled = together < LEAST_BLOCK_CELLS;
        int level = field.blockLevel((int) Math.min(together / 2, cells));
        int width = isSampled ? 1 : LEAST_BLOCK_CELLS << level;
        Column before = null;
        for (int at = from / width; at * width <= to; at++) {
            Column now = isSampled ? samples(at) : at * width < cells ? blocks(level, at) : null;
            if (before != null && now != null) {
                line(before.coordinate, before.greatest, now.coordinate, now.greatest, major);
                line(before.coordinate, before.least, now.coordinate, now.least, minor);
            } else if (now != null && at == 0) {
                line(first, now.least, first, now.greatest, minor);
            }
            before = now == null ? before : now;
        }
        if (to == cells && before != null) {
            double last = first + cells * cell;
            line(last, before.least, last, before.greatest, minor);
        }
    }

    private Column samples(int at) {
        int count = (isAlongZ ? field.cellRows() : field.cellColumns()) + 1;
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double height = isAlongZ ? field.height(at, i) : field.height(i, at);
            least = Math.min(least, height);
            greatest = Math.max(greatest, height);
        }
        return new Column(isAlongZ ? field.x(at) : field.z(at), field.y(least), field.y(greatest));
    }

    private Column blocks(int level, int at) {
        int count = isAlongZ ? field.blockRows(level) : field.blockColumns(level);
        double[] bounds = new double[6];
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            field.writeBlock(level, isAlongZ ? at : i, isAlongZ ? i : at, bounds);
            least = Math.min(least, bounds[1]);
            greatest = Math.max(greatest, bounds[4]);
        }
        int axis = isAlongZ ? 0 : 2;
        return new Column((bounds[axis] + bounds[axis + 3]) / 2, least, greatest);
    }

    private void line(double from, double fromY, double to, double toY, PlanSegments lines) {
        lines.add(across(from), upwards(fromY), across(to), upwards(toY));
    }

    private double across(double coordinate) {
        double metres =
                isAlongZ ? coordinate - camera.centre().x() : camera.centre().z() - coordinate;
        return size.width() / 2.0 + metres / camera.metresPerPixel();
    }

    private double upwards(double y) {
        return size.height() / 2.0 - (y - camera.centre().y()) / camera.metresPerPixel();
    }
}
