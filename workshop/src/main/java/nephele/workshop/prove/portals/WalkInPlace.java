package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.level.Body;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.ViewAngles;
import org.joml.Vector3d;

/**
 * A level in which portals are shot and walked into: draws shots at walls that take portals down to the floor, and
 * walks with free ground. It looks at the solids alone and knows nothing of how a portal is placed.
 */
final class WalkInPlace {
    /** Edge of the cube that is pushed and carried. */
    static final double CUBE_METRES = 0.5;

    private static final double CUBE_KILOGRAMS = 12;
    /** A cube that is not needed waits this far above the level. */
    private static final double AWAY_METRES = 1e4;

    private static final Vec3 DOWN = new Vec3(0, -1, 0);
    private static final double FARTHEST_METRES = 12;
    private static final double ON_FACE_METRES = 1e-5;

    /** Greatest difference in height of the shooter's feet and the floor before the wall. */
    private static final double LEVEL_METRES = 0.2;

    private static final double PATH_STEP_METRES = 0.2;
    private static final double PATH_RISE_METRES = 0.3;

    /** A player who touches the wall is this far from it. */
    private static final double AT_WALL_METRES = PlayerDimensions.RADIUS_METRES + 0.02;

    final String name;
    final SimLevel level;
    final Vec3 cubeAway;
    private final List<Brush> brushes;
    private final List<Brush.BrushFace> walls = new ArrayList<>();
    private final PortalWorld world;
    private final CollisionWorld statics;
    private final Depenetration depenetration = new Depenetration();

    WalkInPlace(String name, PlacedLevel placed) {
        this.name = name;
        brushes = new ArrayList<>(placed.statics().solids());
        brushes.addAll(placed.statics().models().solids());
        for (Brush brush : brushes) {
            for (Brush.BrushFace face : brush.faces()) {
                if (face.portalable() && Math.abs(face.plane().ny()) < ON_FACE_METRES) {
                    walls.add(face);
                }
            }
        }
        statics = CollisionWorld.of(placed.statics());
        world = PortalWorld.of(statics);
        Level authored = placed.level();
        cubeAway = new Vec3(0, (statics.size() == 0 ? 0 : statics.extent().maxY()) + AWAY_METRES, 0);
        List<Body> bodies = new ArrayList<>();
        bodies.add(new Body.Box(
                "walk-in-cube",
                cubeAway,
                new Vec3(CUBE_METRES, CUBE_METRES, CUBE_METRES),
                CUBE_KILOGRAMS,
                null,
                0.6,
                0));
        Level with = authored.with(authored.materials(), authored.solids(), bodies)
                .with(authored.player(), authored.portalGun() == null ? WalkInRooms.GUN : authored.portalGun())
                .withPortals(List.of());
        level = SimLevel.of(placed.edited(with));
    }

    /** Returns true if shots can be drawn at all. */
    boolean hasWalls() {
        return !walls.isEmpty();
    }

    /**
     * Returns a player who looks horizontally at a wall that takes portals to the floor, to shoot; {@code null} if a draw
     * fails.
     */
    PlayerState shooter(SplittableRandom random) {
        Brush.BrushFace face = walls.get(random.nextInt(walls.size()));
        Vec3 normal = face.plane().normal();
        Vec3 on = between(face.polygon(), random);
        double angle = Math.toRadians(random.nextDouble(-65, 65));
        double away = random.nextDouble(0.6, 8);
        Vec3 from = on.addScaled(away, turned(normal, angle));
        double ground = groundY(from, FARTHEST_METRES);
        Vec3 feet = new Vec3(from.x(), ground, from.z());
        if (Double.isNaN(ground) || !isFree(feet)) {
            return null;
        }
        Stance stance = random.nextInt(5) == 0 ? Stance.CROUCHED : Stance.STANDING;
        Vec3 direction = turned(normal, angle).negated();
        Vec3 eye = new Vec3(feet.x(), feet.y() + stance.eyeMetres(), feet.z());
        double metres = distance(eye, direction, 3 * FARTHEST_METRES);
        if (Double.isNaN(metres)) {
            return null;
        }
        Vec3 hit = eye.addScaled(metres, direction);
        Brush.BrushFace wall = wallAt(hit, direction);
        if (wall == null || !takesPortalsToFloor(hit, wall.plane().normal(), feet.y())) {
            return null;
        }
        return new PlayerState(feet, Vec3.ZERO, heading(direction), stance.eyeMetres(), stance, null, false);
    }

    private static Vec3 between(List<Vec3> polygon, SplittableRandom random) {
        Vec3 sum = Vec3.ZERO;
        double all = 0;
        for (Vec3 corner : polygon) {
            double weight = -StrictMath.log(1 - random.nextDouble());
            sum = sum.addScaled(weight, corner);
            all += weight;
        }
        return new Vec3(sum.x() / all, sum.y() / all, sum.z() / all);
    }

    static ViewAngles heading(Vec3 direction) {
        return ViewAngles.ofDegrees(Math.toDegrees(StrictMath.atan2(-direction.x(), -direction.z())), 0);
    }

    /** Returns a direction turned about the vertical. */
    static Vec3 turned(Vec3 v, double radians) {
        double cos = StrictMath.cos(radians);
        double sin = StrictMath.sin(radians);
        return new Vec3(cos * v.x() + sin * v.z(), v.y(), cos * v.z() - sin * v.x());
    }

    /** Returns true if the wall under a point takes portals from the floor to a portal's height, and one can stand there. */
    private boolean takesPortalsToFloor(Vec3 hit, Vec3 normal, double shooterY) {
        double floor = groundY(hit.addScaled(AT_WALL_METRES, normal), FARTHEST_METRES);
        if (Double.isNaN(floor) || Math.abs(floor - shooterY) > LEVEL_METRES) {
            return false;
        }
        double tall = level.gun() == null ? 0 : WalkInRooms.GUN.heightMetres();
        for (double up = 0.02; up < tall; up += 0.2) {
            Vec3 before = new Vec3(hit.x(), floor + up, hit.z()).addScaled(0.25, normal);
            double metres = distance(before, normal.negated(), 0.3);
            Brush.BrushFace there =
                    Double.isNaN(metres) ? null : wallAt(before.addScaled(-metres, normal), normal.negated());
            if (there == null || Math.abs(there.plane().signedDistance(hit)) > 1e-3) {
                return false;
            }
        }
        return hasGroundBefore(hit, normal, floor);
    }

    private boolean hasGroundBefore(Vec3 at, Vec3 normal, double floor) {
        Vec3 end = at.addScaled(AT_WALL_METRES, normal);
        Vec3 start = at.addScaled(1.3, normal);
        return !Double.isNaN(groundAfter(new Vec3(start.x(), floor, start.z()), end));
    }

    /** Returns true if a portal has free ground before it that its lower edge may be near to. */
    boolean hasGroundBefore(Portal portal) {
        Vec3 before = portal.world(0, 0, AT_WALL_METRES);
        double ground = groundY(before, FARTHEST_METRES);
        return !Double.isNaN(ground) && hasGroundBefore(portal.centre(), portal.normal(), ground);
    }

    /**
     * Returns a player on free ground who looks at a portal's centre from an angle to its normal; {@code null} if
     * something is in the way.
     */
    PlayerState before(Portal portal, double metres, double angleRadians) {
        Vec3 away = turned(portal.normal(), angleRadians);
        Vec3 from = portal.centre().addScaled(metres, away);
        double ground = groundY(from, FARTHEST_METRES);
        double last = AT_WALL_METRES / StrictMath.cos(angleRadians);
        Vec3 feet = new Vec3(from.x(), ground, from.z());
        Vec3 end = portal.centre().addScaled(Math.min(metres, last), away);
        double there = groundY(portal.world(0, 0, AT_WALL_METRES), FARTHEST_METRES);
        if (Double.isNaN(ground) || !(Math.abs(groundAfter(feet, end) - there) <= PATH_RISE_METRES)) {
            return null;
        }
        return PlayerState.standing(feet, heading(away.negated()));
    }

    /**
     * Returns the height of the ground where a player ends who walks straight, over steps and slopes that need no jump;
     * NaN if something is in the way.
     */
    private double groundAfter(Vec3 from, Vec3 to) {
        double length = Math.hypot(to.x() - from.x(), to.z() - from.z());
        int steps = (int) Math.ceil(length / PATH_STEP_METRES);
        double ground = from.y();
        for (int i = 0; i <= steps; i++) {
            double fraction = steps == 0 ? 0 : (double) i / steps;
            Vec3 at = new Vec3(
                    from.x() + fraction * (to.x() - from.x()), ground + 1, from.z() + fraction * (to.z() - from.z()));
            double next = groundY(at, 1 + PATH_RISE_METRES);
            if (!(Math.abs(next - ground) <= PATH_RISE_METRES) || !isFree(new Vec3(at.x(), next, at.z()))) {
                return Double.NaN;
            }
            ground = next;
        }
        return ground;
    }

    /** Returns true if a player stands free; on a slope a capsule over the ground's point is higher. */
    private boolean isFree(Vec3 feet) {
        for (double up : new double[] {0, 0.05, 0.1}) {
            Vector3d centre = feet.toVector().add(0, Stance.STANDING.centreAboveFeet() + up, 0);
            if (depenetration.isFree(statics, Stance.STANDING.shape(), centre)) {
                return true;
            }
        }
        return false;
    }

    private double groundY(Vec3 from, double most) {
        double metres = distance(from, DOWN, most);
        return Double.isNaN(metres) ? Double.NaN : from.y() - metres;
    }

    private double distance(Vec3 from, Vec3 direction, double most) {
        double fraction = world.free(from.toVector(), direction.toVector().mul(most));
        return fraction < 1 ? fraction * most : Double.NaN;
    }

    /** Returns the upright face on which portals may be that a ray has hit; {@code null} for anything else. */
    private Brush.BrushFace wallAt(Vec3 hit, Vec3 direction) {
        for (Brush.BrushFace face : walls) {
            if (Math.abs(face.plane().signedDistance(hit)) < ON_FACE_METRES
                    && face.plane().normal().dot(direction) < 0
                    && isWithin(face, hit)) {
                return face;
            }
        }
        return null;
    }

    private static boolean isWithin(Brush.BrushFace face, Vec3 p) {
        List<Vec3> corners = face.polygon();
        Vec3 normal = face.plane().normal();
        for (int i = 0; i < corners.size(); i++) {
            Vec3 a = corners.get(i);
            Vec3 b = corners.get((i + 1) % corners.size());
            if (b.minus(a).cross(p.minus(a)).dot(normal) < -ON_FACE_METRES) {
                return false;
            }
        }
        return true;
    }
}
