package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalShape;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * Rooms of random size, height and heading whose walls take portals down to the floor: with pillars, inner walls,
 * pilasters of 2 to 5 cm, plinths, steps and ramps that take none. One in four is 10 km away from the origin.
 */
final class WalkInRooms {
    static final PortalGun GUN = new PortalGun(1.2, 2.1, PortalShape.ARCH, 500);

    private static final double OFF_METRES = 1e4;

    private final SplittableRandom random;
    private final Vec3 origin;
    private final double cos;
    private final double sin;
    private final List<Solid> solids = new ArrayList<>();

    private WalkInRooms(SplittableRandom random) {
        this.random = random;
        double off = random.nextInt(4) == 0 ? OFF_METRES : 0;
        origin = new Vec3(off, off / 8, -off);
        double turn = random.nextInt(3) == 0 ? 0 : random.nextDouble(2 * Math.PI);
        cos = StrictMath.cos(turn);
        sin = StrictMath.sin(turn);
    }

    static PlacedLevel of(long number) {
        return new WalkInRooms(new SplittableRandom(number)).room();
    }

    private PlacedLevel room() {
        double x = random.nextDouble(3, 9);
        double z = random.nextDouble(3, 9);
        double high = random.nextBoolean() ? random.nextDouble(2.2, 3) : random.nextDouble(3, 7);
        double thick = random.nextDouble(0.05, 1);
        box(-x - 1, -0.5, -z - 1, x + 1, 0, z + 1, false);
        box(-x - 1, high, -z - 1, x + 1, high + 0.5, z + 1, false);
        box(-x - thick, -0.5, -z - 1, -x, high, z + 1, true);
        box(x, -0.5, -z - 1, x + thick, high, z + 1, true);
        box(-x, -0.5, -z - thick, x, high, -z, true);
        box(-x, -0.5, z, x, high, z + thick, true);
        innerWall(x, z, high);
        for (int i = random.nextInt(3); i > 0; i--) {
            double at = random.nextDouble(-x + 1, x - 1);
            double along = random.nextDouble(-z + 1, z - 1);
            double half = random.nextDouble(0.1, 0.4);
            box(at - half, 0, along - half, at + half, high, along + half, false);
        }
        for (int i = random.nextInt(4); i > 0; i--) {
            double at = random.nextDouble(-x, x - 0.3);
            double deep = random.nextDouble(0.02, 0.05);
            double wide = random.nextDouble(0.05, 0.3);
            box(at, 0, -z, at + wide, high, -z + deep, false);
        }
        if (random.nextBoolean()) {
            double rise = random.nextDouble(0.05, 0.35);
            box(-x, 0, z - random.nextDouble(2, 3), random.nextDouble(-x + 2, x), rise, z, false);
        }
        if (random.nextBoolean()) {
            ramp(x, z);
        }
        PlayerStart start = new PlayerStart(at(0, 0, 0), 0, 0);
        var dark = new Environment(null, null, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        Level level =
                Level.of("room", "", dark, List.of()).with(List.of(), solids).with(start, GUN);
        return PlacedLevel.of(level, null);
    }

    /** Adds a wall of 0.1 to 0.6 m through the room that leaves a passage of 1.5 m. */
    private void innerWall(double x, double z, double high) {
        double half = random.nextDouble(0.05, 0.3);
        double at = random.nextDouble(-x / 3, x / 3);
        box(at - half, 0, -z, at + half, high, z - 1.5, true);
    }

    /** Adds a ramp of up to 30 degrees along the last wall. */
    private void ramp(double x, double z) {
        double slope = StrictMath.tan(Math.toRadians(random.nextDouble(5, 30)));
        double rise = random.nextDouble(0.3, 1);
        double length = rise / slope;
        Vec3 normal = Directions.unit(new Vec3(-slope, 1, 0));
        solids.add(new Solid.Planes(
                "ramp",
                null,
                false,
                TextureMapping.WORLD,
                List.of(
                        face(normal, x - length, 0, 0),
                        face(new Vec3(0, -1, 0), 0, 0, 0),
                        face(new Vec3(1, 0, 0), x, 0, 0),
                        face(new Vec3(0, 0, 1), 0, 0, z),
                        face(new Vec3(0, 0, -1), 0, 0, z - 1.8))));
    }

    private void box(double x0, double y0, double z0, double x1, double y1, double z1, boolean portalable) {
        if (x1 - x0 < 0.01 || z1 - z0 < 0.01) {
            return;
        }
        if (sin == 0) {
            solids.add(new Solid.Box(
                    "s" + solids.size(),
                    null,
                    portalable,
                    TextureMapping.WORLD,
                    at((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2),
                    new Vec3(x1 - x0, y1 - y0, z1 - z0),
                    Map.of()));
            return;
        }
        solids.add(new Solid.Planes(
                "s" + solids.size(),
                null,
                portalable,
                TextureMapping.WORLD,
                List.of(
                        face(new Vec3(1, 0, 0), x1, 0, 0),
                        face(new Vec3(-1, 0, 0), x0, 0, 0),
                        face(new Vec3(0, 1, 0), 0, y1, 0),
                        face(new Vec3(0, -1, 0), 0, y0, 0),
                        face(new Vec3(0, 0, 1), 0, 0, z1),
                        face(new Vec3(0, 0, -1), 0, 0, z0))));
    }

    private Solid.PlaneFace face(Vec3 normal, double x, double y, double z) {
        Vec3 turned = turned(normal);
        return new Solid.PlaneFace(turned, turned.dot(at(x, y, z)), null, null, null);
    }

    private Vec3 at(double x, double y, double z) {
        return origin.plus(turned(new Vec3(x, y, z)));
    }

    private Vec3 turned(Vec3 v) {
        return new Vec3(cos * v.x() + sin * v.z(), v.y(), cos * v.z() - sin * v.x());
    }
}
