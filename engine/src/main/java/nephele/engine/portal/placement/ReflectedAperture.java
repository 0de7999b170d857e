package nephele.engine.portal.placement;

import nephele.engine.portal.Aperture;

/**
 * An aperture in a plane's frame, reflected at its centre: its Minkowski sum with an obstacle is the set of centres at
 * which the aperture would reach the obstacle.
 */
final class ReflectedAperture {
    /** x, y of each corner, counter-clockwise from the lowest, and among those the leftmost. */
    private final double[] reflected;

    private final double reachX;
    private final double reachY;

    /** @param upX,upY the aperture's up in the plane's frame, of unit length */
    ReflectedAperture(Aperture aperture, double upX, double upY) {
        int count = aperture.corners();
        double[] corners = new double[2 * count];
        int lowest = 0;
        double farX = 0;
        double farY = 0;
        for (int i = 0; i < count; i++) {
            double x = -(aperture.cornerX(i) * upY + aperture.cornerY(i) * upX);
            double y = -(aperture.cornerY(i) * upY - aperture.cornerX(i) * upX);
            corners[2 * i] = x;
            corners[2 * i + 1] = y;
            farX = Math.max(farX, Math.abs(x));
            farY = Math.max(farY, Math.abs(y));
            boolean lower = y < corners[2 * lowest + 1] || y == corners[2 * lowest + 1] && x < corners[2 * lowest];
            lowest = lower ? i : lowest;
        }
        reflected = new double[2 * count];
        for (int i = 0; i < count; i++) {
            int from = (lowest + i) % count;
            reflected[2 * i] = corners[2 * from];
            reflected[2 * i + 1] = corners[2 * from + 1];
        }
        reachX = farX;
        reachY = farY;
    }

    int corners() {
        return reflected.length / 2;
    }

    double x(int corner) {
        return reflected[2 * (corner % corners())];
    }

    double y(int corner) {
        return reflected[2 * (corner % corners()) + 1];
    }

    /** Returns the greatest extent of the aperture from its centre along x. */
    double reachX() {
        return reachX;
    }

    double reachY() {
        return reachY;
    }
}
