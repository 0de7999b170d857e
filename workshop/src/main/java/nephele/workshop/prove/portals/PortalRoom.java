package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;

/**
 * A room with one pair of portals on its walls, floor, ceiling or on a slanted block; half of those on walls reach the
 * floor. Walls are 2 cm to 1 m thick, there is furniture, and one room in four is 10 km away from the origin.
 */
final class PortalRoom {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final double HALF = 5;
    private static final double HIGH = 4;
    private static final double ROUNDING_METRES = 1e-9;
    private static final int DRAWS = 200;
    /** The free distance in front of a portal that is not on the ramp. */
    private static final double RAMP_METRES = 0.7;

    private static final PortalShape[] SHAPES = PortalShape.values();

    private final SplittableRandom random;
    private final Vec3 origin;
    private final List<Collider> solids = new ArrayList<>();
    private final CollisionWorld world;
    private final Portals portals;

    private PortalRoom(SplittableRandom random) {
        this.random = random;
        double out = random.nextInt(4) == 0 ? 10_000 : 0;
        origin = new Vec3(out, out / 8, -out);
        double thick = StrictMath.pow(10, -1.7 + 1.7 * random.nextDouble());
        slab(-HALF - thick, -thick, -HALF - thick, HALF + thick, 0, HALF + thick);
        slab(-HALF - thick, HIGH, -HALF - thick, HALF + thick, HIGH + thick, HALF + thick);
        slab(-HALF - thick, 0, -HALF - thick, -HALF, HIGH, HALF + thick);
        slab(HALF, 0, -HALF - thick, HALF + thick, HIGH, HALF + thick);
        slab(-HALF, 0, -HALF - thick, HALF, HIGH, -HALF);
        slab(-HALF, 0, HALF, HALF, HIGH, HALF + thick);
        Portal ramp = ramp();
        Aperture aperture = Aperture.of(SHAPES[random.nextInt(SHAPES.length)], 1.2, 2.1);
        List<Portal> ends = ends(aperture, ramp);
        furniture(ends);
        world = new CollisionWorld(solids);
        portals = new Portals(ends, List.of(1, 0));
    }

    static PortalRoom of(SplittableRandom random) {
        return new PortalRoom(random);
    }

    CollisionWorld world() {
        return world;
    }

    Portals portals() {
        return portals;
    }

    /** Returns the middle of the floor. */
    Vec3 origin() {
        return origin;
    }

    /** Returns true if a point is within the room's walls or on one, as in a portal. */
    boolean holds(Vec3 p) {
        return Math.abs(p.x() - origin.x()) < HALF + ROUNDING_METRES
                && Math.abs(p.z() - origin.z()) < HALF + ROUNDING_METRES
                && p.y() > origin.y() - ROUNDING_METRES
                && p.y() < origin.y() + HIGH + ROUNDING_METRES;
    }

    private void slab(double x0, double y0, double z0, double x1, double y1, double z1) {
        Aabb box = new Aabb(x0, y0, z0, x1, y1, z1).moved(origin);
        solids.add(new Collider("slab" + solids.size(), ConvexPolyhedron.box(box)));
    }

    private Vec3 at(double x, double y, double z) {
        return origin.addScaled(1, new Vec3(x, y, z));
    }

    /** Adds a block in the south-east corner with a slanted face, and returns the frame in the middle of that face. */
    private Portal ramp() {
        double lean = Math.toRadians(random.nextInt(15, 75));
        double turn = Math.toRadians(random.nextInt(150, 210));
        Vec3 n = new Vec3(
                StrictMath.cos(lean) * StrictMath.sin(turn),
                StrictMath.sin(lean),
                StrictMath.cos(lean) * StrictMath.cos(turn));
        Portal frame =
                new Portal("ramp", at(2.5, 1.1, 2.5), Portal.facing(n, UP), Aperture.of(PortalShape.ARCH, 1.2, 2.1));
        solids.add(new Collider(
                "ramp",
                ConvexPolyhedron.fromPlanes(List.of(
                        through(frame.normal(), frame.centre()),
                        through(frame.frame().right(), frame.world(1.2, 0, 0)),
                        through(frame.frame().right().negated(), frame.world(-1.2, 0, 0)),
                        through(frame.frame().up(), frame.world(0, 1.3, 0)),
                        through(new Vec3(0, -1, 0), origin),
                        through(frame.normal().negated(), frame.world(0, 0, -2.2))))));
        return frame;
    }

    private static Plane through(Vec3 n, Vec3 p) {
        return Plane.through(n, p);
    }

    private List<Portal> ends(Aperture aperture, Portal ramp) {
        int kind = random.nextInt(10);
        if (kind < 2) {
            return adjoining(aperture, kind == 0);
        }
        for (int i = 0; i < DRAWS; i++) {
            Portal a = end("a", random.nextInt(7), aperture, ramp);
            Portal b = end("b", random.nextInt(7), aperture, ramp);
            if (apart(a, b) && isOffRamp(a, ramp) && isOffRamp(b, ramp)) {
                return List.of(a, b);
            }
        }
        throw new IllegalStateException("no two portals apart in " + DRAWS + " draws");
    }

    /** Returns two portals that share an edge: in a corner of the room, or side by side in a wall. */
    private List<Portal> adjoining(Aperture aperture, boolean inCorner) {
        double half = aperture.widthMetres() / 2;
        double sill = aperture.heightMetres() / 2 + (random.nextBoolean() ? 0 : random.nextDouble());
        Vec3 south = new Vec3(0, 0, 1);
        Portal a = portal("a", at(-HALF + half, sill, -HALF), south, UP, aperture);
        Portal b = inCorner
                ? portal("b", at(-HALF, sill, -HALF + half), new Vec3(1, 0, 0), UP, aperture)
                : portal("b", at(-HALF + 3 * half, sill, -HALF), south, UP, aperture);
        return List.of(a, b);
    }

    private Portal end(String id, int face, Aperture aperture, Portal ramp) {
        double half = aperture.widthMetres() / 2;
        double tall = aperture.heightMetres() / 2;
        double along = random.nextInt(6) == 0 ? HALF - half : random.nextDouble(-HALF + half, HALF - half);
        double sill = random.nextBoolean() ? tall : random.nextDouble(tall, HIGH - tall);
        double turn = random.nextInt(4) * Math.PI / 2 + (random.nextBoolean() ? 0 : random.nextDouble());
        Vec3 lying = new Vec3(StrictMath.sin(turn), 0, StrictMath.cos(turn));
        double x = random.nextDouble(-HALF + 1.3, HALF - 1.3);
        double z = random.nextDouble(-HALF + 1.3, 0);
        return switch (face) {
            case 0 -> portal(id, at(along, sill, -HALF), new Vec3(0, 0, 1), UP, aperture);
            case 1 -> portal(id, at(-HALF, sill, along), new Vec3(1, 0, 0), UP, aperture);
            case 2 -> portal(id, at(along, sill, HALF), new Vec3(0, 0, -1), UP, aperture);
            case 3 -> portal(id, at(HALF, sill, along), new Vec3(-1, 0, 0), UP, aperture);
            case 4 -> portal(id, at(x, 0, z), UP, lying, aperture);
            case 5 -> portal(id, at(x, HIGH, z), new Vec3(0, -1, 0), lying, aperture);
            default -> new Portal(id, ramp.centre(), ramp.frame(), aperture);
        };
    }

    private static Portal portal(String id, Vec3 centre, Vec3 normal, Vec3 up, Aperture aperture) {
        return new Portal(id, centre, Portal.facing(normal, up), aperture);
    }

    /**
     * Returns true if the apertures share no more than an edge: they are in different planes, or far enough apart in
     * one.
     */
    private static boolean apart(Portal a, Portal b) {
        boolean coplanar =
                Math.abs(a.inFront(b.centre().x(), b.centre().y(), b.centre().z())) < 1e-6
                        && a.normal().dot(b.normal()) > 0.99;
        Vec3 p = b.centre();
        double across = Math.abs(a.across(p.x(), p.y(), p.z()));
        double upward = Math.abs(a.upward(p.x(), p.y(), p.z()));
        double side = a.aperture().widthMetres();
        double tall = a.aperture().heightMetres();
        boolean lying = Math.abs(a.normal().y()) > 0.99;
        boolean beside = lying ? Math.hypot(across, upward) > Math.hypot(side, tall) : across >= side || upward >= tall;
        return !coplanar || beside;
    }

    /** Returns true if the portal is the ramp's own or has free space in front of it. */
    private boolean isOffRamp(Portal end, Portal ramp) {
        if (end.frame().equals(ramp.frame())) {
            return true;
        }
        Aabb block = solids.get(solids.size() - 1).bounds();
        return !reaches(end, RAMP_METRES, block.moved(origin.negated()));
    }

    /** Adds boxes on the floor, some close in front of an exit but none in it. */
    private void furniture(List<Portal> ends) {
        double before = random.nextDouble(0.01, 0.7);
        for (int i = random.nextInt(9); i > 0; i--) {
            double x = random.nextDouble(-HALF, HALF);
            double z = random.nextDouble(-HALF, HALF);
            double size = random.nextDouble(0.1, 0.9);
            double high = random.nextDouble(0.05, 1.2);
            Aabb box = new Aabb(x - size, 0, z - size, x + size, high, z + size);
            boolean free = ends.stream().noneMatch(end -> reaches(end, before, box));
            if (free) {
                slab(box.minX(), 0, box.minZ(), box.maxX(), high, box.maxZ());
            }
        }
    }

    /** Returns true if a box is within {@code least} metres in front of an aperture. */
    private boolean reaches(Portal end, double least, Aabb box) {
        List<Vec3> corners = new ArrayList<>();
        for (int i = 0; i < end.aperture().corners(); i++) {
            for (double before : new double[] {0, least}) {
                Vec3 p = end.world(end.aperture().cornerX(i), end.aperture().cornerY(i), before);
                corners.add(p.minus(origin));
            }
        }
        return Aabb.of(corners).overlaps(box);
    }
}
