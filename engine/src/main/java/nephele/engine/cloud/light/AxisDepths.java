package nephele.engine.cloud.light;

/**
 * Optical depths from a point to the outside of a cloud along both directions of the axes.
 *
 * @param x towards +x, {@code minusX} towards −x; the others likewise; +y is up
 */
public record AxisDepths(double x, double minusX, double y, double minusY, double z, double minusZ) {
    /** Depth of other clouds on each side, divided by their depth along the vertical. */
    private static final double WIDTH = 2;

    /**
     * Returns the depths with those of other clouds added that lie above and below. They count on all sides, since such clouds
     * are wide: torn cloud under a deck is a part of its slab.
     */
    public AxisDepths with(double above, double below) {
        double aside = WIDTH * (above + below);
        return new AxisDepths(x + aside, minusX + aside, y + above, minusY + below, z + aside, minusZ + aside);
    }

    /**
     * Returns the thickness of the slab that the cloud resembles at the point: Σ 1/τ² over the axes is that of a slab in
     * any orientation, and a ball's is less than its diameter since light leaks from all its sides.
     */
    public double slabThickness() {
        double sum = inverseSquare(x + minusX) + inverseSquare(y + minusY) + inverseSquare(z + minusZ);
        return 1 / Math.sqrt(sum);
    }

    /** Returns how much the cloud resembles a slab that is parallel to two axes: 0 for a ball, 1 for a layer. */
    public double flatness() {
        double a = x + minusX;
        double b = y + minusY;
        double c = z + minusZ;
        double least = Math.min(a, Math.min(b, c));
        double middle = Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
        return middle > 0 ? Math.max(0, 1 - 2 * least / middle) : 0;
    }

    private static double inverseSquare(double depth) {
        return 1 / Math.max(depth * depth, 1e-20);
    }
}
