package nephele.engine.lightning;

import nephele.engine.level.Environment.Lightning;
import nephele.engine.math.Chance;
import nephele.engine.math.Vec3;

/**
 * The channel of a strike: polylines one after the other, the main channel first, then its branches. Each is made by
 * recursive midpoint displacement (Fournier, Fussell and Carpenter 1982, "Computer Rendering of Stochastic Models");
 * branches leave the channel downwards and are shorter and weaker than it (Reed and Wyvill 1994, "Visual Simulation of
 * Lightning", section 3, where a segment turns by 16° on the mean). One object serves all strikes.
 */
public final class Bolt {
    /** Numbers of a point: x, y, z in metres from the {@link #origin}, and the fraction of the current. */
    public static final int STRIDE = 4;

    public static final int MOST_POINTS = 1280;

    /** Segments of the main channel. */
    public static final int MAIN_SEGMENTS = 256;

    private static final int BRANCHES = 11;
    private static final int BRANCH_SEGMENTS = 32;
    private static final int TWIGS = 3;
    private static final int TWIG_SEGMENTS = 8;
    /** Displacement of a midpoint as a fraction of the distance between its neighbours: turns of some 16° on the mean. */
    private static final double DISPLACED = 0.17;

    private static final int PURPOSE_X = 200;
    private static final int PURPOSE_Z = 3000;
    private static final int PURPOSE_BRANCH = 6000;

    private final float[] points = new float[STRIDE * MOST_POINTS];
    private final boolean[] begins = new boolean[MOST_POINTS];
    private final double[] path = new double[3 * (MAIN_SEGMENTS + 1)];
    private Vec3 origin = Vec3.ZERO;
    private int count;
    private long dice;
    private double lengthMetres;

    /** Takes the channel of a strike. */
    void follow(Lightning lightning, long strikeDice) {
        dice = strikeDice;
        count = 0;
        Vec3 half = lightning.size().scaled(0.5);
        origin = lightning
                .centre()
                .plus(new Vec3(
                        half.x() * Chance.signed(dice, 1),
                        half.y() * Chance.signed(dice, 2),
                        half.z() * Chance.signed(dice, 3)));
        Vec3 end = end(lightning, half).minus(origin);
        lengthMetres = Math.sqrt(end.x() * end.x() + end.y() * end.y() + end.z() * end.z());
        line(0, 0, 0, end.x(), end.y(), end.z(), MAIN_SEGMENTS, 1, 0);
        branches();
    }

    private Vec3 end(Lightning lightning, Vec3 half) {
        boolean strikesGround = Chance.unit(dice, 4) < lightning.groundShare();
        if (strikesGround && origin.y() > lightning.groundAltitudeMetres()) {
            double fall = origin.y() - lightning.groundAltitudeMetres();
            return new Vec3(
                    origin.x() + 0.3 * fall * Chance.signed(dice, 5),
                    lightning.groundAltitudeMetres(),
                    origin.z() + 0.3 * fall * Chance.signed(dice, 6));
        }
        return lightning
                .centre()
                .plus(new Vec3(
                        half.x() * Chance.signed(dice, 7),
                        half.y() * Chance.signed(dice, 8),
                        half.z() * Chance.signed(dice, 9)));
    }

    private void branches() {
        for (int branch = 0; branch < BRANCHES; branch++) {
            int purpose = PURPOSE_BRANCH + 20 * branch;
            double along = 0.04 + 0.76 * (branch + Chance.unit(dice, purpose)) / BRANCHES;
            int from = (int) (along * MAIN_SEGMENTS);
            double length = lengthMetres * (1 - along) * (0.15 + 0.4 * Chance.unit(dice, purpose + 1));
            double fraction = 0.25 + 0.3 * Chance.unit(dice, purpose + 2);
            int first = fork(from, 0, MAIN_SEGMENTS, length, BRANCH_SEGMENTS, fraction, purpose + 3);
            for (int twig = 0; twig < TWIGS; twig++) {
                int place = first + 3 + (int) ((BRANCH_SEGMENTS - 6) * Chance.unit(dice, purpose + 6 + 4 * twig));
                fork(
                        place,
                        first,
                        BRANCH_SEGMENTS,
                        0.35 * length,
                        TWIG_SEGMENTS,
                        0.5 * fraction,
                        purpose + 7 + 4 * twig);
            }
        }
    }

    /**
     * Adds a branch at a point of a polyline, turned from the direction in which the polyline goes as a whole.
     *
     * @param first point of the polyline, of so many segments
     * @return the first point of the branch
     */
    private int fork(int from, int first, int segments, double length, int ownSegments, double fraction, int purpose) {
        int last = first + segments;
        double x = points[STRIDE * last] - points[STRIDE * first];
        double y = points[STRIDE * last + 1] - points[STRIDE * first + 1];
        double z = points[STRIDE * last + 2] - points[STRIDE * first + 2];
        double scale = length / Math.max(1e-6, Math.sqrt(x * x + y * y + z * z));
        double sideways = length * (0.45 + 0.4 * Chance.unit(dice, purpose));
        double turns = 2 * Math.PI * Chance.unit(dice, purpose + 1);
        double atX = points[STRIDE * from];
        double atY = points[STRIDE * from + 1];
        double atZ = points[STRIDE * from + 2];
        int begin = count;
        line(
                atX,
                atY,
                atZ,
                atX + scale * x + sideways * Math.cos(turns),
                atY + scale * y,
                atZ + scale * z + sideways * Math.sin(turns),
                ownSegments,
                fraction,
                begin);
        return begin;
    }

    /** Adds a polyline between two points; the number of segments is a power of 2. */
    private void line(
            double x0,
            double y0,
            double z0,
            double x1,
            double y1,
            double z1,
            int segments,
            double fraction,
            int number) {
        put(0, x0, y0, z0);
        put(segments, x1, y1, z1);
        for (int step = segments; step > 1; step /= 2) {
            for (int middle = step / 2; middle < segments; middle += step) {
                displace(middle - step / 2, middle, middle + step / 2, number);
            }
        }
        for (int i = 0; i <= segments; i++) {
            begins[count] = i == 0;
            // A channel ends in a point, and a branch fades towards it.
            double left = number == 0 ? 1 : 1 - (double) i / segments;
            add(path[3 * i], path[3 * i + 1], path[3 * i + 2], fraction * left);
        }
    }

    private void displace(int before, int middle, int after, int number) {
        double x = path[3 * after] - path[3 * before];
        double y = path[3 * after + 1] - path[3 * before + 1];
        double z = path[3 * after + 2] - path[3 * before + 2];
        double most = 1.73 * DISPLACED * Math.sqrt(x * x + y * y + z * z);
        // Mostly across a channel that goes down; along it by less, so that it does not fold.
        put(
                middle,
                path[3 * before] + x / 2 + most * Chance.signed(dice, PURPOSE_X + number + middle),
                path[3 * before + 1] + y / 2 + 0.3 * most * Chance.signed(dice, PURPOSE_X + 1300 + number + middle),
                path[3 * before + 2] + z / 2 + most * Chance.signed(dice, PURPOSE_Z + number + middle));
    }

    private void put(int point, double x, double y, double z) {
        path[3 * point] = x;
        path[3 * point + 1] = y;
        path[3 * point + 2] = z;
    }

    private void add(double x, double y, double z, double fraction) {
        int at = STRIDE * count++;
        points[at] = (float) x;
        points[at + 1] = (float) y;
        points[at + 2] = (float) z;
        points[at + 3] = (float) fraction;
    }

    /** Returns the place from which points are measured: where the main channel starts. */
    public Vec3 origin() {
        return origin;
    }

    public int points() {
        return count;
    }

    /** Returns one of the {@link #STRIDE} numbers of a point. */
    public float get(int point, int number) {
        return points[STRIDE * point + number];
    }

    /** Returns true if a point is the first of a polyline: no segment joins it to the point before. */
    public boolean begins(int point) {
        return begins[point];
    }

    /** Returns the distance from the beginning of the main channel to its end. */
    public double lengthMetres() {
        return lengthMetres;
    }

    /** Returns the place of a fraction of the main channel, 0 at its start, relative to the origin. */
    public Vec3 along(double fraction) {
        int point = (int) Math.round(fraction * MAIN_SEGMENTS);
        return new Vec3(get(point, 0), get(point, 1), get(point, 2));
    }
}
