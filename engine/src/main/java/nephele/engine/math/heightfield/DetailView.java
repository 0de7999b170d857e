package nephele.engine.math.heightfield;

import nephele.engine.math.Vec3;

/**
 * The eye for which the detail of a {@link HeightField} is chosen.
 *
 * @param forward unit direction in the middle of the picture
 * @param along the range of a place within the picture is at least its component along this vector
 * @param leastShare the squared cosine of the angle between the middle and a corner of the picture
 */
public record DetailView(Vec3 eye, Vec3 forward, Vec3 along, double leastShare) {
    /**
     * A range changes by at most this many metres a metre: the gradient of d²/r is longest at d² / r² = 2/3, and
     * {@link #along} is not longer.
     */
    static final double STEEPNESS = 2 / Math.sqrt(3);

    /** Far enough from where {@link #along} would not be a bound; between them, its slope grows from 0. */
    private static final double CLEARLY_CONVEX = 0.25;

    /**
     * Returns the eye of a view.
     *
     * @param right unit direction; so are {@code up} and {@code forward}
     * @param halfWidth of the picture at depth 1
     * @param halfHeight the same
     */
    public static DetailView of(Vec3 eye, Vec3 right, Vec3 up, Vec3 forward, double halfWidth, double halfHeight) {
        double half = Math.sqrt(halfWidth * halfWidth + halfHeight * halfHeight);
        double s = forward.y();
        double c = Math.sqrt(Math.max(0, 1 - s * s));
        double rightwards = c > 0 ? right.y() / c : 0;
        double upwards = c > 0 ? up.y() / c : 0;
        double v = Math.abs(rightwards) * halfWidth + Math.abs(upwards) * halfHeight;
        double u = Math.abs(upwards) * halfWidth + Math.abs(rightwards) * halfHeight;
        return new DetailView(eye, forward, along(forward, u, v, half), 1 / (1 + half * half));
    }

    /**
     * Returns {@link #along}. A place p at depth d that moves upwards by a short way e moves by e q / d² in the picture at
     * depth 1, where q = |d up − s p| and s = up · forward; its range is d²/q. Let p = d (forward + v g + u t), with
     * g = (up − s forward) / c and t at right angles to both: q² = d² ((c − s v)² + s² u²). For the greatest |u| in the picture,
     * d / q is convex in v as long as c − s v ≥ |s u| / √2; then its tangent at v = 0 is nowhere greater. A steep view has
     * the least d / q of the picture instead; between them is a mixture, so that nothing jumps while a view turns.
     */
    private static Vec3 along(Vec3 forward, double u, double v, double half) {
        double s = forward.y();
        double c = Math.sqrt(Math.max(0, 1 - s * s));
        double convex = c - Math.abs(s) * (v + u / Math.sqrt(2));
        double share = Math.max(0, Math.min(1, convex / CLEARLY_CONVEX));
        double middle = share > 0 ? 1 / Math.sqrt(c * c + s * s * u * u) : 0;
        double slope = share * s * middle * middle * middle;
        double ahead = share * middle + (1 - share) / (c + Math.abs(s) * half);
        // c g = up − s forward
        Vec3 vector = forward.scaled(ahead - s * slope).plus(new Vec3(0, slope, 0));
        return vector.scaled(Math.min(1, STEEPNESS / vector.length()));
    }

    /**
     * Returns the range of a place relative to the eye: a point there that moves upwards by a short way e moves by at most
     * e / range in the picture at depth 1. At distance r and depth d, no way e moves it by more than e r / d², so
     * d² / r is such a number, and so is the component along {@link #along}. Beside the picture it is never less than at
     * the picture's corners for the same distance.
     */
    public double range(double x, double y, double z) {
        double distance = Math.sqrt(x * x + y * y + z * z);
        double depth = x * forward.x() + y * forward.y() + z * forward.z();
        double ahead = depth > 0 ? depth * depth / distance : 0;
        double component = x * along.x() + y * along.y() + z * along.z();
        return Math.max(Math.max(ahead, component), distance * leastShare);
    }

    /** Returns a number that no range within a box exceeds downwards. */
    double leastRange(double[] box) {
        double x = (box[0] + box[3]) / 2 - eye.x();
        double y = (box[1] + box[4]) / 2 - eye.y();
        double z = (box[2] + box[5]) / 2 - eye.z();
        double half = DetailTiles.diagonal(box) / 2;
        double beside = nearest(box) * leastShare;
        double least = Math.max(leastComponent(x, y, z, box), range(x, y, z) - STEEPNESS * half);
        return Math.max(Math.max(beside, leastAhead(x, y, z, box, half)), least);
    }

    /** Returns the least component of a place in a box along {@link #along}. */
    private double leastComponent(double x, double y, double z, double[] box) {
        double middle = x * along.x() + y * along.y() + z * along.z();
        return middle - spread(along, box) / 2;
    }

    private static double spread(Vec3 direction, double[] box) {
        return Math.abs(direction.x()) * (box[3] - box[0])
                + Math.abs(direction.y()) * (box[4] - box[1])
                + Math.abs(direction.z()) * (box[5] - box[2]);
    }

    /** Returns the range at the least depth in a box and the farthest from the axis, or 0. */
    private double leastAhead(double x, double y, double z, double[] box, double half) {
        double middle = x * forward.x() + y * forward.y() + z * forward.z();
        double depth = middle - spread(forward, box) / 2;
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
