package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3dc;

/**
 * One to four boxes, balls and capsules of random size, mass, orientation and motion, above each other in the air of a
 * closed room, clear of each other and of every wall. Every third pile is above or beside a pair of portals. The pile's
 * number determines all of it.
 *
 * @param heightMetres from the floor, which is at 0, to the ceiling
 * @param starts initial state of each body of the table
 */
public record DroppedPile(
        long number,
        int ticksPerSecond,
        double heightMetres,
        BodyTable table,
        List<BodyState> starts,
        PilePortals portals) {
    static final double HALF_ROOM_METRES = 6;
    private static final double WALL_METRES = 1;
    private static final double LEAST_ROOM_METRES = 6;
    private static final double LEAST_RATE = 20;
    private static final double MOST_RATE = 1000;
    private static final int MOST_BODIES = 4;
    private static final double LEAST_GAP_METRES = .001;
    private static final double MOST_GAP_METRES = .5;
    /** The greatest horizontal offset of a body from the one below, as a fraction of the wider one's half width. */
    private static final double ASIDE = .6;

    /** The greatest distance from the column's axis along x and z. */
    private static final double MOST_REACH_METRES = 4.5;

    private static final double LEAST_EDGE_METRES = .001;
    private static final double MOST_EDGE_METRES = 2.5;
    private static final double LEAST_KILOGRAMS = .001;
    private static final double MOST_KILOGRAMS = 1000;
    private static final double MOST_METRES_PER_SECOND = 5;
    private static final double MOST_RADIANS_PER_SECOND = 10;
    private static final double FRICTION = .6;

    public static DroppedPile of(long number) {
        SplittableRandom random = new SplittableRandom(number);
        int rate = (int) Math.round(logUniform(random, LEAST_RATE, MOST_RATE));
        int count = 1 + random.nextInt(MOST_BODIES);
        List<Body> bodies = new ArrayList<>();
        List<BodyState> states = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            bodies.add(body(random, "b" + i, logUniform(random, LEAST_KILOGRAMS, MOST_KILOGRAMS)));
            states.add(start(random));
        }
        BodyTable table = new BodyTable(bodies);
        List<BodyState> column = column(random, table, states);
        double reach = 0;
        double top = 0;
        for (int i = 0; i < count; i++) {
            Vec3 centre = column.get(i).centre();
            RoundedHull hull = table.hull(i, column.get(i).orientation());
            top = centre.y() + hull.greatest(1);
            reach = Math.max(reach, Math.abs(centre.x()) + hull.greatest(0));
            reach = Math.max(reach, Math.abs(centre.z()) + hull.greatest(2));
        }
        double height = Math.max(LEAST_ROOM_METRES, top + random.nextDouble(.1, 2));
        PilePortals portals = number % 3 == 0 ? PilePortals.of(random, reach, height) : PilePortals.none(random, reach);
        return new DroppedPile(number, rate, height, table, portals.placed(column), portals);
    }

    /** Returns a state at the origin: upright for half of the bodies, at rest for three quarters. */
    private static BodyState start(SplittableRandom random) {
        Quaterniond turn = random.nextBoolean()
                ? new Quaterniond()
                : Rotations.aroundAxis(direction(random), random.nextDouble(0, Math.PI));
        boolean moves = random.nextInt(4) == 0;
        Vec3 velocity = moves ? upTo(random, MOST_METRES_PER_SECOND) : Vec3.ZERO;
        Vec3 spin = moves ? upTo(random, MOST_RADIANS_PER_SECOND) : Vec3.ZERO;
        return new BodyState(Vec3.ZERO, turn, velocity, spin);
    }

    private static Body body(SplittableRandom random, String id, double kilograms) {
        return switch (random.nextInt(3)) {
            case 0 ->
                new Body.Box(
                        id,
                        Vec3.ZERO,
                        new Vec3(edge(random), edge(random), edge(random)),
                        kilograms,
                        null,
                        FRICTION,
                        0);
            case 1 -> new Body.Sphere(id, Vec3.ZERO, edge(random) / 2, kilograms, null, FRICTION, 0);
            default -> {
                double diameter = edge(random);
                double height = logUniform(random, diameter, MOST_EDGE_METRES);
                yield new Body.Capsule(id, Vec3.ZERO, diameter / 2, height, kilograms, null, FRICTION, 0);
            }
        };
    }

    private static double edge(SplittableRandom random) {
        return logUniform(random, LEAST_EDGE_METRES, MOST_EDGE_METRES);
    }

    private static Vec3 upTo(SplittableRandom random, double most) {
        return direction(random).scaled(random.nextDouble(0, most));
    }

    /** Returns a direction, uniform over the sphere: height and longitude are uniform. */
    private static Vec3 direction(SplittableRandom random) {
        double y = random.nextDouble(-1, 1);
        double longitude = random.nextDouble(0, 2 * Math.PI);
        double r = Math.sqrt(1 - y * y);
        return new Vec3(r * StrictMath.cos(longitude), y, r * StrictMath.sin(longitude));
    }

    /** Returns the states above each other around the axis x = z = 0. */
    private static List<BodyState> column(SplittableRandom random, BodyTable table, List<BodyState> states) {
        List<BodyState> placed = new ArrayList<>();
        double x = 0;
        double z = 0;
        double top = 0;
        double below = 0;
        for (int i = 0; i < states.size(); i++) {
            BodyState state = states.get(i);
            RoundedHull hull = table.hull(i, state.orientation());
            double half = Math.max(hull.greatest(0), hull.greatest(2));
            double aside = i == 0 ? 0 : ASIDE * Math.max(half, below);
            x = within(MOST_REACH_METRES - half, x + aside * random.nextDouble(-1, 1));
            z = within(MOST_REACH_METRES - half, z + aside * random.nextDouble(-1, 1));
            double y = top + logUniform(random, LEAST_GAP_METRES, MOST_GAP_METRES) - hull.least(1);
            placed.add(new BodyState(new Vec3(x, y, z), state.orientation(), state.velocity(), state.spin()));
            top = y + hull.greatest(1);
            below = half;
        }
        return placed;
    }

    private static double within(double most, double x) {
        return Math.max(-most, Math.min(most, x));
    }

    private static double logUniform(SplittableRandom random, double least, double most) {
        return least * StrictMath.pow(most / least, random.nextDouble());
    }

    PortalWorld world() {
        CollisionWorld room = BoxPile.closedRoom(HALF_ROOM_METRES, heightMetres, WALL_METRES);
        return PortalWorld.of(room, portals.portals());
    }

    /** Returns the distance in metres of a point outside the room; not positive inside. */
    double outsideMetres(Vector3dc p) {
        double aside = Math.max(Math.abs(p.x()), Math.abs(p.z())) - HALF_ROOM_METRES;
        return Math.max(aside, Math.max(-p.y(), p.y() - heightMetres));
    }

    boolean hasPortals() {
        return portals.portals() != Portals.NONE;
    }

    /** Returns a description with which the pile can be repeated: the number is the seed. */
    String inWords() {
        StringBuilder words = new StringBuilder(
                String.format(Locale.ROOT, "pile %d, %d ticks/s, %s:", number, ticksPerSecond, portals.kind()));
        for (int i = 0; i < table.size(); i++) {
            words.append(i == 0 ? " " : ", ").append(inWords(table.body(i)));
        }
        return words.toString();
    }

    private static String inWords(Body body) {
        String shape;
        if (body instanceof Body.Box box) {
            shape = String.format(
                    Locale.ROOT,
                    "box %.4f x %.4f x %.4f m",
                    box.size().x(),
                    box.size().y(),
                    box.size().z());
        } else if (body instanceof Body.Capsule capsule) {
            shape = String.format(
                    Locale.ROOT, "capsule %.4f x %.4f m", 2 * capsule.radiusMetres(), capsule.heightMetres());
        } else {
            shape = String.format(Locale.ROOT, "ball %.4f m", 2 * ((Body.Sphere) body).radiusMetres());
        }
        return String.format(Locale.ROOT, "%s %.3g kg", shape, body.massKilograms());
    }
}
