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
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import org.joml.Vector3dc;

/**
 * One to four bodies above each other in the air of a closed room, clear of each other and of every wall. Every third
 * pile is above or beside a pair of portals. The pile's number determines all of it.
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

    public static DroppedPile of(long number) {
        SplittableRandom random = new SplittableRandom(number);
        int rate = (int) Math.round(logUniform(random, LEAST_RATE, MOST_RATE));
        int count = 1 + random.nextInt(MOST_BODIES);
        List<Body> bodies = new ArrayList<>();
        List<BodyState> states = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            DroppedBody drawn = DroppedBody.of(random, i);
            bodies.add(drawn.body());
            states.add(drawn.start());
        }
        BodyTable table = new BodyTable(bodies);
        Column column = column(random, table, states);
        double height = Math.max(LEAST_ROOM_METRES, column.top() + random.nextDouble(.1, 2));
        PilePortals portals = number % 3 == 0
                ? PilePortals.of(random, column.reach(), height)
                : PilePortals.none(random, column.reach());
        return new DroppedPile(number, rate, height, table, portals.placed(column.states()), portals);
    }

    /** Bodies above each other around the axis x = z = 0. */
    private record Column(List<BodyState> states, double top, double reach) {}

    private static Column column(SplittableRandom random, BodyTable table, List<BodyState> states) {
        List<BodyState> placed = new ArrayList<>();
        double x = 0;
        double z = 0;
        double top = 0;
        double below = 0;
        double reach = 0;
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
            reach = Math.max(reach, Math.max(Math.abs(x) + hull.greatest(0), Math.abs(z) + hull.greatest(2)));
        }
        return new Column(placed, top, reach);
    }

    private static double within(double most, double x) {
        return Math.max(-most, Math.min(most, x));
    }

    static double logUniform(SplittableRandom random, double least, double most) {
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
            words.append(i == 0 ? " " : ", ").append(DroppedBody.inWords(table.body(i)));
        }
        return words.toString();
    }
}
