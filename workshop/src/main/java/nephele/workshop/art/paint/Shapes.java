package nephele.workshop.art.paint;

/** Coverage of soft-edged shapes, from 0 outside to 1 inside; lengths are in metres. */
public final class Shapes {
    private Shapes() {}

    /** Returns 0 below {@code from}, 1 above {@code to}, and a smooth blend in between. */
    public static double ramp(double from, double to, double value) {
        double t = Math.max(0, Math.min(1, (value - from) / (to - from)));
        return t * t * (3 - 2 * t);
    }

    /** Returns 1 within {@code radius} of the point, fading over {@code soft}. */
    public static double disc(double dx, double dy, double radius, double soft) {
        return 1 - ramp(radius - soft / 2, radius + soft / 2, Math.sqrt(dx * dx + dy * dy));
    }

    /** Returns 1 where {@code distance} is below {@code halfWidth}, fading over {@code soft}. */
    public static double line(double distance, double halfWidth, double soft) {
        return 1 - ramp(halfWidth - soft / 2, halfWidth + soft / 2, Math.abs(distance));
    }

    /** Returns the signed distance to a rectangle with rounded corners around the origin, negative inside. */
    public static double roundedBox(double x, double y, double halfWidth, double halfHeight, double radius) {
        double dx = Math.abs(x) - halfWidth + radius;
        double dy = Math.abs(y) - halfHeight + radius;
        double outside = Math.sqrt(Math.max(dx, 0) * Math.max(dx, 0) + Math.max(dy, 0) * Math.max(dy, 0));
        return outside + Math.min(Math.max(dx, dy), 0) - radius;
    }
}
