package nephele.lab.trade.subject;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Passage;
import org.joml.Vector3d;

/**
 * How far a view leaps when its eye goes through a portal: a window would show no leap at all.
 *
 * @param degrees by which it turns
 * @param metres by which the eye moves
 * @param pixels by which a 1280×720 picture's middle points move, the mean; what leaves the picture counts as its diagonal
 */
record ViewJump(double degrees, double metres, double pixels) {
    private static final int COLUMNS = 9;
    private static final int ROWS = 5;
    private static final double HALF_WIDTH_PIXELS = 640;
    private static final double HALF_HEIGHT_PIXELS = 360;
    private static final double DIAGONAL_PIXELS = 2 * Math.hypot(HALF_WIDTH_PIXELS, HALF_HEIGHT_PIXELS);
    /** Half the height of the picture at depth 1, for the player's 60°. */
    private static final double TAN_HALF_HEIGHT = Math.tan(Math.toRadians(30));
    /** What one looks at is so far away. */
    private static final double DEPTH_METRES = 5;

    /** @param before the last pose on this side; {@code after} the first on the other */
    static ViewJump of(Passage passage, Gaze before, Gaze after) {
        Gaze expected = before.through(passage);
        Vector3d way = after.eye().toVector().sub(expected.eye().toVector());
        return new ViewJump(turnDegrees(expected.view(), after.view()), way.length(), meanPixels(expected, after));
    }

    /** From sine and cosine of half the angle, so that small turns keep their digits. */
    private static double turnDegrees(Basis a, Basis b) {
        double apart = distance(a.right(), b.right()) + distance(a.up(), b.up()) + distance(a.back(), b.back());
        // Of a turn by t, the squared distances of three axes add up to 8 sin²(t/2).
        return 2 * Math.toDegrees(Math.asin(Math.min(1, Math.sqrt(apart / 8))));
    }

    private static double distance(Vec3 a, Vec3 b) {
        return a.toVector().distanceSquared(b.toVector());
    }

    private static double meanPixels(Gaze expected, Gaze after) {
        double sum = 0;
        for (int column = 0; column < COLUMNS; column++) {
            for (int row = 0; row < ROWS; row++) {
                double x = HALF_WIDTH_PIXELS * ((column + 0.5) / COLUMNS * 2 - 1);
                double y = HALF_HEIGHT_PIXELS * ((row + 0.5) / ROWS * 2 - 1);
                sum += moved(expected, after, x, y);
            }
        }
        return sum / (COLUMNS * ROWS);
    }

    /** Pixels from the middle of the picture, both ways. */
    private static double moved(Gaze expected, Gaze after, double x, double y) {
        double perPixel = TAN_HALF_HEIGHT / HALF_HEIGHT_PIXELS;
        Vector3d point = expected.eye()
                .toVector()
                .fma(-DEPTH_METRES, expected.view().back().toVector())
                .fma(DEPTH_METRES * x * perPixel, expected.view().right().toVector())
                .fma(DEPTH_METRES * y * perPixel, expected.view().up().toVector())
                .sub(after.eye().toVector());
        double depth = -point.dot(after.view().back().toVector());
        double newX = point.dot(after.view().right().toVector()) / depth / perPixel;
        double newY = point.dot(after.view().up().toVector()) / depth / perPixel;
        boolean inside = depth > 0 && Math.abs(newX) <= HALF_WIDTH_PIXELS && Math.abs(newY) <= HALF_HEIGHT_PIXELS;
        return inside ? Math.hypot(newX - x, newY - y) : DIAGONAL_PIXELS;
    }
}
