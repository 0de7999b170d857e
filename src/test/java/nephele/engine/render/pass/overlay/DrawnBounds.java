package nephele.engine.render.pass.overlay;

/** The bounds of what is on a canvas, in points. */
public record DrawnBounds(double left, double top, double right, double bottom) {
    /** Returns the bounds of all quads of a canvas of scale 1. */
    public static DrawnBounds of(OverlayCanvas canvas) {
        double left = Double.POSITIVE_INFINITY;
        double top = left;
        double right = -left;
        double bottom = right;
        for (int i = 0; i < canvas.length(); i += OverlayCanvas.FLOATS_PER_VERTEX) {
            left = Math.min(left, canvas.vertices()[i]);
            right = Math.max(right, canvas.vertices()[i]);
            top = Math.min(top, canvas.vertices()[i + 1]);
            bottom = Math.max(bottom, canvas.vertices()[i + 1]);
        }
        return new DrawnBounds(left, top, right, bottom);
    }
}
