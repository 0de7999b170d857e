package nephele.engine.portal.ground;

import java.util.Arrays;

/**
 * The plane nearest to ground in the greatest deviation. A few corners decide it: it is found for a few, and those
 * farthest from it join them, until no corner is farther than the few. For the few it is the limit of weighted
 * least-squares planes, whose weights are multiplied by the deviations (Lawson 1961). The root mean square of each is a
 * lower bound, so ground that is too uneven is recognised early.
 */
final class NearestPlane {
    private static final int MOST_ROUNDS = 16;
    private static final int MOST_STEPS = 60;
    private static final double EXACT_METRES = 1e-5;

    /** Least share of the greatest deviation with which a weight is multiplied, so that none vanishes for good. */
    private static final double LEAST_FACTOR = 1e-6;

    /** Determinant, relative to the product of the diagonal, below which the corners lie on a line. */
    private static final double ON_LINE = 1e-12;

    private final ApertureGround ground;
    private int[] few = new int[16];
    private int count;
    private double[] weights = new double[16];

    private double slopeX;
    private double slopeY;
    private double atLeast;

    private double trialX;
    private double trialY;
    private double trialHeight;

    private NearestPlane(ApertureGround ground) {
        this.ground = ground;
    }

    /**
     * Finds the plane.
     *
     * @param enoughMetres deviation beyond which no plane is wanted
     */
    static NearestPlane to(ApertureGround ground, double enoughMetres) {
        NearestPlane plane = new NearestPlane(ground);
        plane.beginWithEnds();
        for (int round = 0; round < MOST_ROUNDS; round++) {
            double deviation = plane.fitFew(enoughMetres);
            if (plane.atLeast > enoughMetres || !plane.addFarthest(deviation)) {
                break;
            }
        }
        return plane;
    }

    /** Returns the rise of the plane along the portal's x. */
    double slopeX() {
        return slopeX;
    }

    /** Returns the rise of the plane along the portal's y. */
    double slopeY() {
        return slopeY;
    }

    /** Returns the plane's greatest deviation from the ground. */
    double greatestMetres() {
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < ground.size(); i++) {
            least = Math.min(least, above(i));
            greatest = Math.max(greatest, above(i));
        }
        return (greatest - least) / 2;
    }

    /** Returns a lower bound of every plane's greatest deviation. */
    double atLeastMetres() {
        return atLeast;
    }

    /** Chooses the ends of the ground in eight directions. */
    private void beginWithEnds() {
        for (int direction = 0; direction < 8; direction++) {
            double x = new int[] {1, 1, 0, -1}[direction & 3];
            double y = new int[] {0, 1, 1, 1}[direction & 3];
            double sign = direction < 4 ? 1 : -1;
            int best = 0;
            double farthest = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < ground.size(); i++) {
                double along = sign * (x * ground.across(i) + y * ground.upward(i));
                if (along > farthest) {
                    farthest = along;
                    best = i;
                }
            }
            choose(best);
        }
    }

    private boolean choose(int corner) {
        for (int i = 0; i < count; i++) {
            if (few[i] == corner) {
                return false;
            }
        }
        if (count == few.length) {
            few = Arrays.copyOf(few, 2 * count);
            weights = Arrays.copyOf(weights, 2 * count);
        }
        few[count++] = corner;
        return true;
    }

    /** Adds the corners farthest above and below; returns false if they are no farther than the few. */
    private boolean addFarthest(double deviation) {
        int lowest = 0;
        int highest = 0;
        for (int i = 1; i < ground.size(); i++) {
            double height = above(i);
            lowest = height < above(lowest) ? i : lowest;
            highest = height > above(highest) ? i : highest;
        }
        if ((above(highest) - above(lowest)) / 2 <= deviation + EXACT_METRES) {
            return false;
        }
        boolean isNew = choose(lowest);
        return choose(highest) || isNew;
    }

    private double above(int corner) {
        return ground.inFront(corner) - slopeX * ground.across(corner) - slopeY * ground.upward(corner);
    }

    /** Finds the slopes of the plane nearest to the few; returns its greatest deviation from them. */
    private double fitFew(double enoughMetres) {
        Arrays.fill(weights, 0, count, 1.0 / count);
        double best = Double.POSITIVE_INFINITY;
        for (int step = 0; step < MOST_STEPS && best - atLeast > EXACT_METRES; step++) {
            if (!fitWeighted()) {
                return 0;
            }
            double greatest = 0;
            double square = 0;
            for (int i = 0; i < count; i++) {
                double off = Math.abs(off(few[i]));
                greatest = Math.max(greatest, off);
                square += weights[i] * off * off;
            }
            if (greatest < best) {
                best = greatest;
                slopeX = trialX;
                slopeY = trialY;
            }
            atLeast = Math.max(atLeast, Math.sqrt(square));
            if (atLeast > enoughMetres) {
                break;
            }
            reweigh(greatest);
        }
        return best;
    }

    private double off(int corner) {
        return ground.inFront(corner) - trialHeight - trialX * ground.across(corner) - trialY * ground.upward(corner);
    }

    private void reweigh(double greatest) {
        double sum = 0;
        for (int i = 0; i < count; i++) {
            weights[i] *= Math.max(Math.abs(off(few[i])), LEAST_FACTOR * greatest);
            sum += weights[i];
        }
        for (int i = 0; i < count; i++) {
            weights[i] = sum > 0 ? weights[i] / sum : 1.0 / count;
        }
    }

    /** Fits a plane by weighted least squares; returns false if the few lie on a line. */
    private boolean fitWeighted() {
        double x = 0;
        double y = 0;
        double height = 0;
        for (int i = 0; i < count; i++) {
            x += weights[i] * ground.across(few[i]);
            y += weights[i] * ground.upward(few[i]);
            height += weights[i] * ground.inFront(few[i]);
        }
        double xx = 0;
        double xy = 0;
        double yy = 0;
        double xh = 0;
        double yh = 0;
        for (int i = 0; i < count; i++) {
            double dx = ground.across(few[i]) - x;
            double dy = ground.upward(few[i]) - y;
            double dh = ground.inFront(few[i]) - height;
            xx += weights[i] * dx * dx;
            xy += weights[i] * dx * dy;
            yy += weights[i] * dy * dy;
            xh += weights[i] * dx * dh;
            yh += weights[i] * dy * dh;
        }
        double determinant = xx * yy - xy * xy;
        if (!(determinant > ON_LINE * xx * yy)) {
            return false;
        }
        trialX = (yy * xh - xy * yh) / determinant;
        trialY = (xx * yh - xy * xh) / determinant;
        trialHeight = height - trialX * x - trialY * y;
        return true;
    }
}
