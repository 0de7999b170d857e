package nephele.lab.trade.subject;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PortalTransform;
import org.joml.Vector3d;

/**
 * The jump of a view when its eye goes through a portal, relative to a view through a window, which would not jump.
 *
 * @param degrees rotation of the view
 * @param metres displacement of the eye
 * @param pixels mean displacement of the points of a grid in a 1280 × 720 picture; a point that leaves the picture
 *     counts as the picture's diagonal
 */
record ViewJump(double degrees, double metres, double pixels) {
    private static final int COLUMNS = 9;
    private static final int ROWS = 5;
    private static final double HALF_WIDTH_PIXELS = 640;
    private static final double HALF_HEIGHT_PIXELS = 360;
    private static final double DIAGONAL_PIXELS = 2 * Math.hypot(HALF_WIDTH_PIXELS, HALF_HEIGHT_PIXELS);
    /** Half the height of the picture at depth 1, for the player's 60°. */
    private static final double TAN_HALF_HEIGHT = Math.tan(Math.toRadians(30));
    /** The assumed distance of the seen points. */
    private static final double DEPTH_METRES = 5;

    /**
     * @param before the last pose in front of the portal
     * @param after the first pose behind it
     */
    static ViewJump of(PortalTransform transform, ViewPose before, ViewPose after) {
        ViewPose expected = before.through(transform);
        Vector3d displacement = after.eye().toVector().sub(expected.eye().toVector());
        return new ViewJump(
                turnDegrees(expected.view(), after.view()), displacement.length(), meanPixels(expected, after));
    }

    /** Computed from the sine of half the angle, so that small rotations keep their precision. */
    private static double turnDegrees(Basis a, Basis b) {
        double apart = distance(a.right(), b.right()) + distance(a.up(), b.up()) + distance(a.back(), b.back());
        // For a rotation by t, the squared distances of three axes add up to 8 sin²(t/2).
        return 2 * Math.toDegrees(Math.asin(Math.min(1, Math.sqrt(apart / 8))));
    }

    private static double distance(Vec3 a, Vec3 b) {
        return a.toVector().distanceSquared(b.toVector());
    }

    private static double meanPixels(ViewPose expected, ViewPose after) {
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

    /**
     * Returns the displacement of a point, in pixels.
     *
     * @param x pixels to the right of the picture's middle
     * @param y pixels up from the picture's middle
     */
    private static double moved(ViewPose expected, ViewPose after, double x, double y) {
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
