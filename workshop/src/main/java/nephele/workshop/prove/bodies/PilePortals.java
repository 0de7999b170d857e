package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;

/**
 * A pair of portals in the room of a dropped pile, or none, and the place of the pile's axis.
 *
 * @param kind the faces of the room with the two portals
 * @param axis x and z of the column; y is 0
 * @param push velocity added to that of each body, in m/s
 */
record PilePortals(String kind, Portals portals, Vec3 axis, Vec3 push) {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final double ROOM = DroppedPile.HALF_ROOM_METRES;
    private static final double GAP_METRES = .001;
    private static final double MOST_WIDTH_METRES = 1.2;
    private static final double MOST_HEIGHT_METRES = 2.1;
    /** The smallest aperture relative to the largest. */
    private static final double LEAST_FRACTION = .15;
    /** The greatest offset of the column's axis from the aperture's middle, as a fraction of half its sides. */
    private static final double BESIDE = 1.3;

    private static final double MOST_PUSH_METRES_PER_SECOND = 5;
    /** The greatest height of a sill; with it an aperture ends below every ceiling. */
    private static final double MOST_SILL_METRES = 3;

    private static final Vec3[] INTO_ROOM = {
        new Vec3(1, 0, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(0, 0, -1)
    };
    private static final PortalShape[] SHAPES = PortalShape.values();

    /** @param reach greatest distance of the bodies from the axis along x or z, in metres */
    static PilePortals none(SplittableRandom random, double reach) {
        double free = ROOM - reach - GAP_METRES;
        double x = random.nextDouble(-1, 1) * free;
        double z = random.nextDouble(-1, 1) * free;
        boolean atWall = random.nextInt(4) == 0;
        return new PilePortals("no portals", Portals.NONE, new Vec3(atWall ? free : x, 0, z), Vec3.ZERO);
    }

    /** Returns a pair in the floor and another face, or in two walls, with the column above or beside one of them. */
    static PilePortals of(SplittableRandom random, double reach, double ceilingMetres) {
        Aperture aperture = Aperture.of(
                SHAPES[random.nextInt(SHAPES.length)],
                MOST_WIDTH_METRES * random.nextDouble(LEAST_FRACTION, 1),
                MOST_HEIGHT_METRES * random.nextDouble(LEAST_FRACTION, 1));
        int wall = random.nextInt(INTO_ROOM.length);
        int other = (wall + 1 + random.nextInt(INTO_ROOM.length - 1)) % INTO_ROOM.length;
        return switch (random.nextInt(4)) {
            case 0 -> beside("floor and floor", floor(random, -1, aperture), floor(random, 1, aperture), random, reach);
            case 1 -> beside("floor and wall", floor(random, 1, aperture), wall(random, wall, aperture), random, reach);
            case 2 ->
                beside("wall and wall", wall(random, wall, aperture), wall(random, other, aperture), random, reach);
            default -> {
                Portal below = floor(random, 1, aperture);
                yield beside("floor and ceiling", below, ceiling(random, below, ceilingMetres), random, reach);
            }
        };
    }

    /** Returns a portal in the eastern (1) or western (−1) half of the floor. */
    private static Portal floor(SplittableRandom random, int side, Aperture aperture) {
        double turn = random.nextDouble(0, 2 * Math.PI);
        Vec3 up = new Vec3(StrictMath.sin(turn), 0, StrictMath.cos(turn));
        Vec3 centre = new Vec3(side * random.nextDouble(1.3, 4.7), 0, random.nextDouble(-4.7, 4.7));
        return new Portal("a" + side, centre, Portal.facing(UP, up), aperture);
    }

    /** Returns a portal in the ceiling, straight above the one in the floor or anywhere. */
    private static Portal ceiling(SplittableRandom random, Portal below, double metres) {
        boolean over = random.nextBoolean();
        double x = over ? below.centre().x() : random.nextDouble(-4.7, 4.7);
        double z = over ? below.centre().z() : random.nextDouble(-4.7, 4.7);
        return new Portal(
                "ceiling",
                new Vec3(x, metres, z),
                Portal.facing(new Vec3(0, -1, 0), below.frame().up()),
                below.aperture());
    }

    /** Returns a portal in a wall, on the floor or higher. */
    private static Portal wall(SplittableRandom random, int wall, Aperture aperture) {
        Vec3 normal = INTO_ROOM[wall];
        double free = ROOM - aperture.widthMetres() / 2;
        double along = random.nextDouble(-free, free);
        double sill = random.nextBoolean() ? 0 : random.nextDouble(0, MOST_SILL_METRES);
        Vec3 centre = new Vec3(
                -normal.x() * ROOM + Math.abs(normal.z()) * along,
                sill + aperture.heightMetres() / 2,
                -normal.z() * ROOM + Math.abs(normal.x()) * along);
        return new Portal("wall" + wall, centre, Portal.facing(normal, UP), aperture);
    }

    private static PilePortals beside(String kind, Portal a, Portal b, SplittableRandom random, double reach) {
        Portals pair = new Portals(List.of(a, b), List.of(1, 0));
        Portal near = b.normal().y() < 0 || random.nextBoolean() ? a : b;
        double across = BESIDE * near.aperture().widthMetres() / 2 * random.nextDouble(-1, 1);
        double upward = BESIDE * near.aperture().heightMetres() / 2 * random.nextDouble(-1, 1);
        boolean lies = near.normal().y() > .5;
        Vec3 axis =
                lies ? near.world(across, upward, 0) : near.world(across, 0, reach + random.nextDouble(GAP_METRES, .5));
        double speed = lies || random.nextBoolean() ? 0 : random.nextDouble(0, MOST_PUSH_METRES_PER_SECOND);
        Vec3 push =
                new Vec3(-speed * near.normal().x(), 0, -speed * near.normal().z());
        return new PilePortals(kind, pair, new Vec3(inRoom(axis.x(), reach), 0, inRoom(axis.z(), reach)), push);
    }

    private static double inRoom(double x, double reach) {
        double most = ROOM - reach - GAP_METRES;
        return Math.max(-most, Math.min(most, x));
    }

    /** Returns the column's bodies, placed in the room. */
    List<BodyState> placed(List<BodyState> column) {
        List<BodyState> placed = new ArrayList<>();
        for (BodyState state : column) {
            Vec3 c = state.centre();
            Vec3 v = state.velocity();
            placed.add(new BodyState(
                    new Vec3(c.x() + axis.x(), c.y(), c.z() + axis.z()),
                    state.orientation(),
                    new Vec3(v.x() + push.x(), v.y(), v.z() + push.z()),
                    state.spin()));
        }
        return placed;
    }
}
