package nephele.engine.portal.ground;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;

/**
 * The ground under an aperture and a rim around it: the triangles of a terrain, clipped along the portal's normal, and
 * the plane nearest to them. Heights above a plane are linear on each triangle, so their extremes are at the corners kept
 * here, in the portal's axes.
 */
final class ApertureGround {
    /** Width of the rim around the aperture; the drawn rim is as wide. */
    static final double RIM_METRES = 0.1;

    /** Ground that is wholly farther than this from the portal's plane is another slope. */
    private static final double FAR_METRES = 0.25;

    private static final int SAMPLE_COLUMNS = 4;
    private static final int SAMPLE_ROWS = 6;

    private static final int MOST_ROUNDS = 16;
    private static final int MOST_STEPS = 60;
    private static final double EXACT_METRES = 1e-5;

    /** Least fraction of the greatest deviation with which a weight is multiplied, so that none vanishes for good. */
    private static final double LEAST_FACTOR = 1e-6;

    /** Determinant, relative to the product of the diagonal, below which the corners lie on a line. */
    private static final double ON_LINE = 1e-12;

    private final Portal portal;
    private final Aperture aperture;
    /** For each corner: across, upward, in front. */
    private double[] corners = new double[3 * 64];

    private int count;
    private double[] piece = new double[3 * (Aperture.MOST_CORNERS + 4)];
    private double[] clipped = new double[3 * (Aperture.MOST_CORNERS + 4)];

    /** The corners that decide the nearest plane, and their weights. */
    private int[] few = new int[16];

    private int fewCount;
    private double[] weights = new double[16];

    private double slopeX;
    private double slopeY;
    private double atLeast;

    private double trialX;
    private double trialY;
    private double trialHeight;

    private ApertureGround(Portal portal) {
        this.portal = portal;
        aperture = portal.aperture();
    }

    static ApertureGround under(HeightField field, Portal portal) {
        ApertureGround ground = new ApertureGround(portal);
        Aabb box = ground.box();
        List<Integer> triangles = new ArrayList<>();
        field.passing(box::overlaps, triangles::add);
        triangles.sort(null);
        for (int triangle : triangles) {
            ground.add(field, triangle);
        }
        return ground;
    }

    /** Returns a few points of the ground well inside an aperture. */
    static ApertureGround sampled(HeightField field, Portal portal) {
        ApertureGround ground = new ApertureGround(portal);
        for (int row = 0; row < SAMPLE_ROWS; row++) {
            for (int column = 0; column < SAMPLE_COLUMNS; column++) {
                ground.sample(field, (column + 0.5) / SAMPLE_COLUMNS - 0.5, (row + 0.5) / SAMPLE_ROWS - 0.5);
            }
        }
        return ground;
    }

    /** Adds the ground above or below a point of the plane, given in widths and heights of the aperture. */
    private void sample(HeightField field, double across, double upward) {
        Vec3 on = portal.world(across * aperture.widthMetres(), upward * aperture.heightMetres(), 0);
        double y = HeightFieldSurface.y(field, on.x(), on.z());
        double x = portal.across(on.x(), y, on.z());
        double up = portal.upward(on.x(), y, on.z());
        if (aperture.outside(x, up) <= 0) {
            corners[3 * count] = x;
            corners[3 * count + 1] = up;
            corners[3 * count + 2] = portal.inFront(on.x(), y, on.z());
            count++;
        }
    }

    private Aabb box() {
        double x = aperture.widthMetres() / 2 + 2 * RIM_METRES;
        double y = aperture.heightMetres() / 2 + 2 * RIM_METRES;
        List<Vec3> ends = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            ends.add(portal.world(
                    (i & 1) == 0 ? x : -x, (i & 2) == 0 ? y : -y, (i & 4) == 0 ? FAR_METRES : -FAR_METRES));
        }
        return Aabb.of(ends);
    }

    private void add(HeightField field, int triangle) {
        boolean isInside = true;
        for (int corner = 0; corner < 3; corner++) {
            Vec3 p = field.corner(triangle, corner);
            piece[3 * corner] = portal.across(p.x(), p.y(), p.z());
            piece[3 * corner + 1] = portal.upward(p.x(), p.y(), p.z());
            piece[3 * corner + 2] = portal.inFront(p.x(), p.y(), p.z());
            isInside &= aperture.outside(piece[3 * corner], piece[3 * corner + 1]) <= RIM_METRES;
        }
        int left = isInside ? 3 : clip(3);
        if (left > 0 && isNear(left)) {
            if (3 * (count + left) > corners.length) {
                corners = Arrays.copyOf(corners, 2 * corners.length + 3 * left);
            }
            System.arraycopy(piece, 0, corners, 3 * count, 3 * left);
            count += left;
        }
    }

    /** Clips the piece at the aperture's edges, moved outwards by the rim (Sutherland and Hodgman 1974). */
    private int clip(int before) {
        int size = before;
        for (int edge = 0; edge < aperture.corners() && size > 0; edge++) {
            int kept = 0;
            for (int i = 0; i < size; i++) {
                int next = (i + 1) % size;
                double here = beyond(edge, i);
                double there = beyond(edge, next);
                if (here <= 0) {
                    System.arraycopy(piece, 3 * i, clipped, 3 * kept++, 3);
                }
                if (here < 0 && there > 0 || here > 0 && there < 0) {
                    double fraction = here / (here - there);
                    for (int axis = 0; axis < 3; axis++) {
                        double from = piece[3 * i + axis];
                        clipped[3 * kept + axis] = from + fraction * (piece[3 * next + axis] - from);
                    }
                    kept++;
                }
            }
            double[] swapped = piece;
            piece = clipped;
            clipped = swapped;
            size = kept;
        }
        return size;
    }

    private double beyond(int edge, int corner) {
        return aperture.edgeNormalX(edge) * piece[3 * corner]
                + aperture.edgeNormalY(edge) * piece[3 * corner + 1]
                - aperture.edgeDistance(edge)
                - RIM_METRES;
    }

    private boolean isNear(int size) {
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < size; i++) {
            least = Math.min(least, piece[3 * i + 2]);
            greatest = Math.max(greatest, piece[3 * i + 2]);
        }
        return least <= FAR_METRES && greatest >= -FAR_METRES;
    }

    int size() {
        return count;
    }

    double across(int corner) {
        return corners[3 * corner];
    }

    double upward(int corner) {
        return corners[3 * corner + 1];
    }

    double inFront(int corner) {
        return corners[3 * corner + 2];
    }

    /** Returns the height in front of the portal's plane of the ground's lowest part; infinity for none. */
    double lowest() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            least = Math.min(least, inFront(i));
        }
        return least;
    }

    /** Returns the height in front of the portal's plane of the ground's highest part; −infinity for none. */
    double highest() {
        double greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            greatest = Math.max(greatest, inFront(i));
        }
        return greatest;
    }

    /**
     * Finds the plane nearest to the ground in the greatest deviation; the accessors below refer to it. A few corners
     * decide it: it is found for a few, and those farthest from it join them, until no corner is farther than the few. For
     * the few it is the limit of weighted least-squares planes, whose weights are multiplied by the deviations (Lawson
     * 1961). The root mean square of each is a lower bound, so ground that is too uneven is recognised early.
     *
     * @param enoughMetres deviation beyond which no plane is wanted
     */
    ApertureGround fit(double enoughMetres) {
        fewCount = 0;
        slopeX = 0;
        slopeY = 0;
        atLeast = 0;
        beginWithEnds();
        for (int round = 0; round < MOST_ROUNDS; round++) {
            double deviation = fitFew(enoughMetres);
            if (atLeast > enoughMetres || !addFarthest(deviation)) {
                break;
            }
        }
        return this;
    }

    /** Returns the rise of the plane along the portal's x. */
    double slopeX() {
        return slopeX;
    }

    /** Returns the rise of the plane along the portal's y. */
    double slopeY() {
        return slopeY;
    }

    /** Returns the plane's greatest deviation from the  */
    double greatestMetres() {
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
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
            for (int i = 0; i < count; i++) {
                double along = sign * (x * across(i) + y * upward(i));
                if (along > farthest) {
                    farthest = along;
                    best = i;
                }
            }
            choose(best);
        }
    }

    private boolean choose(int corner) {
        for (int i = 0; i < fewCount; i++) {
            if (few[i] == corner) {
                return false;
            }
        }
        if (fewCount == few.length) {
            few = Arrays.copyOf(few, 2 * fewCount);
            weights = Arrays.copyOf(weights, 2 * fewCount);
        }
        few[fewCount++] = corner;
        return true;
    }

    /** Adds the corners farthest above and below; returns false if they are no farther than the few. */
    private boolean addFarthest(double deviation) {
        int lowest = 0;
        int highest = 0;
        for (int i = 1; i < count; i++) {
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
        return inFront(corner) - slopeX * across(corner) - slopeY * upward(corner);
    }

    /** Finds the slopes of the plane nearest to the few; returns its greatest deviation from them. */
    private double fitFew(double enoughMetres) {
        Arrays.fill(weights, 0, fewCount, 1.0 / fewCount);
        double best = Double.POSITIVE_INFINITY;
        for (int step = 0; step < MOST_STEPS && best - atLeast > EXACT_METRES; step++) {
            if (!fitWeighted()) {
                return 0;
            }
            double greatest = 0;
            double square = 0;
            for (int i = 0; i < fewCount; i++) {
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
        return inFront(corner) - trialHeight - trialX * across(corner) - trialY * upward(corner);
    }

    private void reweigh(double greatest) {
        double sum = 0;
        for (int i = 0; i < fewCount; i++) {
            weights[i] *= Math.max(Math.abs(off(few[i])), LEAST_FACTOR * greatest);
            sum += weights[i];
        }
        for (int i = 0; i < fewCount; i++) {
            weights[i] = sum > 0 ? weights[i] / sum : 1.0 / fewCount;
        }
    }

    /** Fits a plane by weighted least squares; returns false if the few lie on a line. */
    private boolean fitWeighted() {
        double x = 0;
        double y = 0;
        double height = 0;
        for (int i = 0; i < fewCount; i++) {
            x += weights[i] * across(few[i]);
            y += weights[i] * upward(few[i]);
            height += weights[i] * inFront(few[i]);
        }
        double xx = 0;
        double xy = 0;
        double yy = 0;
        double xh = 0;
        double yh = 0;
        for (int i = 0; i < fewCount; i++) {
            double dx = across(few[i]) - x;
            double dy = upward(few[i]) - y;
            double dh = inFront(few[i]) - height;
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
