package nephele.engine.render.pass.edge;

/** The part of a pixel beyond the straight line that an edge of the pixel grid stands for; twin of {@code line-area.glsl}. */
public final class LineArea {
    private LineArea() {}

    /**
     * Returns the area, 0 to ½.
     *
     * @param before pixels of the edge before the pixel
     * @param after pixels of the edge behind it
     * @param atStart 1 if the edge that crosses at its start is on the pixel's side, −1 on the other one, 0 for neither or
     *     both: the line begins half a pixel off the edge towards that side
     * @param atEnd likewise at its end
     */
    public static double beyond(double before, double after, double atStart, double atEnd) {
        double middle = 0.5 * (before + 1 + after);
        double start = falling(before + 1, middle, 0.5 * atStart) - falling(before, middle, 0.5 * atStart);
        double end = falling(after + 1, middle, 0.5 * atEnd) - falling(after, middle, 0.5 * atEnd);
        return Math.max(start, 0) + Math.max(end, 0);
    }

    /** Returns the integral from 0 to x of a line that falls from {@code height} at 0 to 0 at {@code middle}. */
    private static double falling(double x, double middle, double height) {
        double t = Math.min(x, middle);
        return height * t * (1 - 0.5 * t / middle);
    }
}
