package nephele.workshop.prove.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * A closed room of walls of 10 cm over a ground, determined by its number. At each edge its walls are flush, overlap, or
 * one ends at the middle of the other; walls consist of one or two brushes; pillars stand half in walls, boxes touch
 * walls and each other, and a wall divides the room up to a doorway. In every other room all lengths are whole
 * millimetres.
 */
final class LeakRoom {
    private static final double WALL_METRES = 0.1;

    /** How far out a wall reaches beyond the inner edge that it shares with another, and the other wall. */
    private static final double[][] JOINTS = {
        {WALL_METRES, 0},
        {0, WALL_METRES},
        {WALL_METRES, WALL_METRES},
        {WALL_METRES, WALL_METRES / 2},
        {0.4, 0},
        {0, 0.3},
        {0.25, 0.35}
    };

    private static final double SUN = 1e5;
    private static final double SKY = 1e4;
    private static final double LAMP = 100;

    /** Places among which the one farthest from everything is chosen. */
    private static final int TRIES = 20;

    private final WhiteBoxes boxes = new WhiteBoxes();
    private final List<Aabb> furniture = new ArrayList<>();
    private final SplittableRandom random;
    private final boolean isRounded;
    private final double[] low = new double[3];
    private final double[] high = new double[3];

    LeakRoom(long number) {
        random = new SplittableRandom(number);
        isRounded = number % 2 == 0;
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = length(-20, 20);
            high[axis] = low[axis] + length(1.2, axis == 1 ? 1.8 : 2.4);
        }
        walls();
        furnish();
        box(
                new double[] {low[0] - 0.5, low[1] - 0.7, low[2] - 0.5},
                new double[] {high[0] + 0.5, low[1] - 0.5, high[2] + 0.5});
    }

    private double length(double least, double most) {
        double length = least + (most - least) * random.nextDouble();
        return isRounded ? Math.rint(1000 * length) / 1000 : length;
    }

    private void walls() {
        double[][] from = new double[6][];
        double[][] to = new double[6][];
        for (int wall = 0; wall < 6; wall++) {
            from[wall] = low.clone();
            to[wall] = high.clone();
            int axis = wall / 2;
            (wall % 2 == 0 ? to : from)[wall][axis] = (wall % 2 == 0 ? low : high)[axis];
            (wall % 2 == 0 ? from : to)[wall][axis] += wall % 2 == 0 ? -WALL_METRES : WALL_METRES;
        }
        for (int wall = 0; wall < 6; wall++) {
            for (int other = wall - wall % 2 + 2; other < 6; other++) {
                double[] joint = JOINTS[random.nextInt(JOINTS.length)];
                reach(from[wall], to[wall], other, joint[0]);
                reach(from[other], to[other], wall, joint[1]);
            }
        }
        for (int wall = 0; wall < 6; wall++) {
            wall(from[wall], to[wall], wall / 2);
        }
    }

    private static void reach(double[] from, double[] to, int beyond, double metres) {
        if (beyond % 2 == 0) {
            from[beyond / 2] -= metres;
        } else {
            to[beyond / 2] += metres;
        }
    }

    /** Adds a wall, in half of the cases as two brushes that touch or overlap. */
    private void wall(double[] from, double[] to, int axis) {
        int across = (axis + 1 + random.nextInt(2)) % 3;
        double[] firstTo = to.clone();
        if (random.nextBoolean()) {
            double at = length(low[across] + 0.2, high[across] - 0.2);
            firstTo[across] = at + (random.nextBoolean() ? 0 : WALL_METRES);
            double[] secondFrom = from.clone();
            secondFrom[across] = at;
            box(secondFrom, to);
        }
        box(from, firstTo);
    }

    private void furnish() {
        int pillars = 1 + random.nextInt(3);
        for (int i = 0; i < pillars; i++) {
            pillar(random.nextInt(2) * 2, random.nextBoolean());
        }
        double[] from = {length(low[0], high[0] - 0.5), low[1], low[2]};
        double[] to = {from[0] + length(0.1, 0.4), low[1] + length(0.1, 0.8), low[2] + length(0.1, 0.4)};
        furniture(from, to);
        double[] beside = {to[0], low[1], low[2]};
        furniture(beside, new double[] {to[0] + length(0.05, 0.3), low[1] + length(0.1, 0.8), low[2] + 0.2});
        double at = length(low[2] + 0.5, high[2] - 0.5);
        boolean isToLow = random.nextBoolean();
        furniture(
                new double[] {isToLow ? low[0] : low[0] + 0.5, low[1], at},
                new double[] {isToLow ? high[0] - 0.5 : high[0], high[1], at + WALL_METRES});
    }

    /** Adds a pillar from floor to ceiling or shorter whose axis is in a wall; a thick one comes out on the other side. */
    private void pillar(int axis, boolean isHigh) {
        double half = length(0.03, 0.2);
        int along = 2 - axis;
        double middle = random.nextBoolean() ? low[axis] - WALL_METRES / 2 : high[axis] + WALL_METRES / 2;
        double[] from = new double[3];
        double[] to = new double[3];
        from[axis] = middle - half;
        to[axis] = middle + half;
        from[along] = length(low[along] - WALL_METRES, high[along] - 0.2);
        to[along] = from[along] + length(0.05, 0.4);
        from[1] = low[1];
        to[1] = isHigh ? high[1] : low[1] + length(0.2, 1.5);
        furniture(from, to);
    }

    private void furniture(double[] from, double[] to) {
        box(from, to);
        furniture.add(new Aabb(from[0], from[1], from[2], to[0], to[1], to[2]));
    }

    private void box(double[] from, double[] to) {
        boxes.box(
                (from[0] + to[0]) / 2,
                (from[1] + to[1]) / 2,
                (from[2] + to[2]) / 2,
                to[0] - from[0],
                to[1] - from[1],
                to[2] - from[2]);
    }

    /** Returns the room under a noon sun and a bright sky. */
    Level atNoon() {
        Vec3 towardsSun = new Vec3(0.8 * random.nextDouble() - 0.4, 1, 0.8 * random.nextDouble() - 0.4);
        return lit(new Sun(towardsSun, grey(SUN), true), new Sky.Constant(grey(SKY)), List.of());
    }

    /** Returns the room in the dark with a lamp inside. */
    Level withLamp() {
        return lit(null, null, List.of(new Light.Point("lamp", freePlace(), grey(LAMP), 40, true)));
    }

    private Level lit(Sun sun, Sky sky, List<Light> lamps) {
        var environment = new Environment(sun, sky, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        var paint = new Material("white", grey(0.3 + 0.5 * random.nextDouble()), null, null, null, null, Vec3.ZERO, 1);
        Level white = boxes.lit(null, List.of());
        return white.with(List.of(paint), white.solids()).with(environment, lamps);
    }

    private static Vec3 grey(double value) {
        return new Vec3(value, value, value);
    }

    /** Returns a random place in the room that is rather far from everything. */
    Vec3 freePlace() {
        Vec3 freest = null;
        double most = 0;
        for (int i = 0; i < TRIES || freest == null; i++) {
            Vec3 place = new Vec3(
                    random.nextDouble(low[0], high[0]),
                    random.nextDouble(low[1], high[1]),
                    random.nextDouble(low[2], high[2]));
            double metres = furniture.stream()
                    .mapToDouble(box -> outside(box, place))
                    .min()
                    .orElseThrow();
            for (int axis = 0; axis < 3; axis++) {
                metres = Math.min(
                        metres,
                        Math.min(
                                place.toVector().get(axis) - low[axis],
                                high[axis] - place.toVector().get(axis)));
            }
            if (metres > most) {
                most = metres;
                freest = place;
            }
        }
        return freest;
    }

    /** Returns the greatest distance along an axis by which a place is outside of a box; negative inside. */
    private static double outside(Aabb box, Vec3 p) {
        double x = Math.max(box.minX() - p.x(), p.x() - box.maxX());
        double y = Math.max(box.minY() - p.y(), p.y() - box.maxY());
        double z = Math.max(box.minZ() - p.z(), p.z() - box.maxZ());
        return Math.max(x, Math.max(y, z));
    }

    /** Returns true for a place in the room or on its inner faces. */
    boolean isInside(Vec3 place) {
        return outside(new Aabb(low[0], low[1], low[2], high[0], high[1], high[2]), place) <= 1e-6;
    }
}
