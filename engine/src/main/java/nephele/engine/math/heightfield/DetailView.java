package nephele.engine.math.heightfield;

import nephele.engine.math.Vec3;

/**
 * The eye for which the detail of a {@link HeightField} is chosen.
 *
 * @param forward unit direction in the middle of the picture
 * @param leastShare the squared cosine of the angle between the middle and a corner of the picture
 */
public record DetailView(Vec3 eye, Vec3 forward, double leastShare) {
    /** A range changes by at most this many metres a metre: the gradient of d²/r is longest at d² / r² = 2/3. */
    static final double STEEPNESS = 2 / Math.sqrt(3);

    /**
     * Returns the range of a place relative to the eye. A point at distance r and depth d that moves by a short way e moves
     * by at most e r / d² in the picture at depth 1; the range is d² / r in the picture, and beside it never less than at the
     * picture's corners for the same distance.
     */
    public double range(double x, double y, double z) {
        double distance = Math.sqrt(x * x + y * y + z * z);
        double depth = x * forward.x() + y * forward.y() + z * forward.z();
        double ahead = depth > 0 ? depth * depth / distance : 0;
        return Math.max(ahead, distance * leastShare);
    }

    /** Returns a number that no range within a box exceeds downwards. */
    double leastRange(double[] box) {
        double x = (box[0] + box[3]) / 2 - eye.x();
        double y = (box[1] + box[4]) / 2 - eye.y();
        double z = (box[2] + box[5]) / 2 - eye.z();
        double half = DetailTiles.diagonal(box) / 2;
        double beside = nearest(box) * leastShare;
        return Math.max(Math.max(beside, leastAhead(x, y, z, box, half)), range(x, y, z) - STEEPNESS * half);
    }

    /** Returns the range at the least depth in a box and the farthest from the axis, or 0. */
    private double leastAhead(double x, double y, double z, double[] box, double half) {
        double middle = x * forward.x() + y * forward.y() + z * forward.z();
        double depth = middle
                - (Math.abs(forward.x()) * (box[3] - box[0])
                                + Math.abs(forward.y()) * (box[4] - box[1])
                                + Math.abs(forward.z()) * (box[5] - box[2]))
                        / 2;
        if (depth <= 0) {
            return 0;
        }
        double aside = Math.sqrt(Math.max(0, x * x + y * y + z * z - middle * middle)) + half;
        return depth * depth / Math.sqrt(depth * depth + aside * aside);
    }

    private double nearest(double[] box) {
        double x = outside(eye.x(), box[0], box[3]);
        double y = outside(eye.y(), box[1], box[4]);
        double z = outside(eye.z(), box[2], box[5]);
        return Math.sqrt(x * x + y * y + z * z);
    }

    private static double outside(double at, double least, double greatest) {
        return Math.max(0, Math.max(least - at, at - greatest));
    }
}
