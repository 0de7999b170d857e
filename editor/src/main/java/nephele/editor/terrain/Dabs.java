package nephele.editor.terrain;

import nephele.engine.level.Terrain;

/**
 * The places of a stroke's dabs: its beginning, then at equal distances along its path. Of those after the beginning only
 * dabs that can reach the terrain are made, so that a path of any length costs no more than one across the terrain.
 */
final class Dabs {
    private final double spacing;
    private final double[] middle;
    private final double[] reach;
    private double x;
    private double z;
    /** The distance from the last dab to the present place. */
    private double since;

    /** A dab at a place. */
    @FunctionalInterface
    interface Dab {
        void at(double x, double z);
    }

    /**
     * @param spacing metres between two dabs along the path
     * @param radius of a dab, metres
     */
    Dabs(Terrain terrain, double spacing, double radius, double x, double z) {
        this.spacing = spacing;
        middle = new double[] {terrain.centre().x(), terrain.centre().z()};
        reach = new double[] {
            terrain.sizeMetres().x() / 2 + radius, terrain.sizeMetres().z() / 2 + radius
        };
        this.x = x;
        this.z = z;
    }

    /** Goes straight to a place. */
    void to(double toX, double toZ, Dab dab) {
        double length = Math.hypot(toX - x, toZ - z);
        double first = spacing - since;
        double count = Math.floor((length - first) / spacing) + 1;
        if (count > 0) {
            double[] fractions = {0, 1};
            clip(0, x, toX, fractions);
            clip(1, z, toZ, fractions);
            double from = Math.max(0, Math.ceil((fractions[0] * length - first) / spacing - 1));
            double to = Math.min(count - 1, Math.floor((fractions[1] * length - first) / spacing + 1));
            for (double i = from; i <= to; i++) {
                double fraction = Math.min(1, (first + i * spacing) / length);
                dab.at(x + fraction * (toX - x), z + fraction * (toZ - z));
            }
        }
        since = count > 0 ? Math.max(0, Math.min(spacing, length - first - (count - 1) * spacing)) : since + length;
        x = toX;
        z = toZ;
    }

    /** Narrows the fractions of the path between which one of its coordinates can reach the terrain. */
    private void clip(int axis, double start, double end, double[] fractions) {
        double low = middle[axis] - reach[axis];
        double high = middle[axis] + reach[axis];
        if (start == end) {
            fractions[1] = start < low || start > high ? -1 : fractions[1];
            return;
        }
        double a = (low - start) / (end - start);
        double b = (high - start) / (end - start);
        fractions[0] = Math.max(fractions[0], Math.min(a, b));
        fractions[1] = Math.min(fractions[1], Math.max(a, b));
    }
}
