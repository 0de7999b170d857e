package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerState;

/**
 * A convex room around the origin that just fits a standing player or is larger: boxes, wedges and slanted rooms of any
 * tilt. Each wall is a slab of its own, 1 mm to 10 cm thick, mostly 1 cm. The room may have furniture.
 */
final class ClosedRoom {
    /** Walls extend this far beyond the edges, so that their slabs overlap. */
    private static final double OVERLAP_METRES = 0.02;

    private static final int FURNITURE_TRIES = 3;

    private static final int DRAWS = 100;
    /** A region free of furniture, so that every room has at least one start. */
    private static final Aabb MIDDLE = Aabb.around(Vec3.ZERO, new Vec3(0.61, 1.82, 0.61));

    private final List<Plane> inner;
    private final CollisionWorld world;

    private ClosedRoom(List<Plane> inner, CollisionWorld world) {
        this.inner = inner;
        this.world = world;
    }

    /** Draws a room. Tilted planes leave a side open about once in a thousand draws; the room is then drawn again. */
    static ClosedRoom of(SplittableRandom random) {
        for (int i = 0; i < DRAWS; i++) {
            try {
                return drawn(random);
            } catch (IllegalArgumentException open) {
                continue;
            }
        }
        throw new IllegalStateException("no closed room in " + DRAWS + " draws");
    }

    private static ClosedRoom drawn(SplittableRandom random) {
        List<Plane> inner = planes(random);
        double thickness = random.nextInt(4) > 0 ? 0.01 : StrictMath.pow(10, -3 + 2 * random.nextDouble());
        List<Collider> solids = new ArrayList<>();
        for (int i = 0; i < inner.size(); i++) {
            wall(inner, i, thickness, solids);
        }
        for (int i = random.nextInt(FURNITURE_TRIES + 1); i > 0; i--) {
            Collider piece = furniture(random);
            if (!piece.bounds().overlaps(MIDDLE)) {
                solids.add(piece);
            }
        }
        return new ClosedRoom(inner, new CollisionWorld(solids));
    }

    private static List<Plane> planes(SplittableRandom random) {
        boolean tilted = random.nextInt(3) > 0;
        double spare = StrictMath.pow(10, -3 + 4 * random.nextDouble());
        List<Plane> planes = new ArrayList<>();
        Vec3[] axes = {
            new Vec3(1, 0, 0), new Vec3(-1, 0, 0), new Vec3(0, 1, 0),
            new Vec3(0, -1, 0), new Vec3(0, 0, 1), new Vec3(0, 0, -1)
        };
        for (Vec3 axis : axes) {
            Vec3 normal = tilted && random.nextBoolean() ? near(axis, random) : axis;
            planes.add(plane(normal, spare * random.nextDouble()));
        }
        for (int i = tilted ? random.nextInt(5) : 0; i > 0; i--) {
            planes.add(plane(near(Vec3.ZERO, random), spare * random.nextDouble()));
        }
        return planes;
    }

    private static Vec3 near(Vec3 axis, SplittableRandom random) {
        double tilt = axis.equals(Vec3.ZERO) ? 1 : 0.55;
        return new Vec3(
                axis.x() + tilt * (2 * random.nextDouble() - 1),
                axis.y() + tilt * (2 * random.nextDouble() - 1),
                axis.z() + tilt * (2 * random.nextDouble() - 1));
    }

    /** Returns a wall as far out as a player standing in the middle needs, plus {@code spare} metres. */
    private static Plane plane(Vec3 normal, double spare) {
        Plane unit = Plane.of(normal, 0);
        double halfAxis = Stance.STANDING.heightMetres() / 2 - PlayerDimensions.RADIUS_METRES;
        double needed = PlayerDimensions.RADIUS_METRES + Math.abs(unit.ny()) * halfAxis + 0.002;
        return new Plane(unit.nx(), unit.ny(), unit.nz(), needed + spare);
    }

    private static void wall(List<Plane> inner, int index, double thickness, List<Collider> solids) {
        List<Plane> slab = new ArrayList<>();
        for (int i = 0; i < inner.size(); i++) {
            Plane p = inner.get(i);
            double out = i == index ? thickness : OVERLAP_METRES;
            slab.add(new Plane(p.nx(), p.ny(), p.nz(), p.distance() + out));
        }
        Plane p = inner.get(index);
        slab.add(p.opposite());
        if (touchesRoom(inner, index)) {
            solids.add(new Collider("wall" + index, ConvexPolyhedron.fromPlanes(slab)));
        }
    }

    /** Returns false if the other planes cut the plane off entirely, so that it is no wall. */
    private static boolean touchesRoom(List<Plane> inner, int index) {
        List<Plane> grown = inner.stream()
                .map(p -> new Plane(p.nx(), p.ny(), p.nz(), p.distance() + OVERLAP_METRES / 2))
                .collect(java.util.stream.Collectors.toCollection(ArrayList::new));
        grown.set(index, inner.get(index));
        return ConvexPolyhedron.fromPlanes(grown).faces().stream().anyMatch(face -> face.planeIndex() == index);
    }

    private static Collider furniture(SplittableRandom random) {
        Vec3 centre = new Vec3(4 * random.nextDouble() - 2, 3 * random.nextDouble() - 1.5, 4 * random.nextDouble() - 2);
        Vec3 size = new Vec3(
                0.01 + 2 * random.nextDouble(), 0.01 + 2 * random.nextDouble(), 0.01 + 2 * random.nextDouble());
        return new Collider("furniture", ConvexPolyhedron.box(Aabb.around(centre, size)));
    }

    CollisionWorld world() {
        return world;
    }

    /**
     * Returns the distance in metres of the player's capsule from the nearest wall plane; negative if it penetrates
     * one.
     */
    double clearance(PlayerState player) {
        Vec3 feet = player.feet();
        double low =
                feet.y() + player.stance().centreAboveFeet() - player.stance().heightMetres() / 2;
        double bottom = low + PlayerDimensions.RADIUS_METRES;
        double top = low + player.stance().heightMetres() - PlayerDimensions.RADIUS_METRES;
        double least = Double.POSITIVE_INFINITY;
        for (Plane plane : inner) {
            double farther = plane.ny() > 0 ? top : bottom;
            least = Math.min(
                    least, -plane.signedDistance(feet.x(), farther, feet.z()) - PlayerDimensions.RADIUS_METRES);
        }
        return Double.isNaN(feet.x() + feet.y() + feet.z()) ? Double.NEGATIVE_INFINITY : least;
    }

    /** Returns a random position of the feet in a box around the room. */
    Vec3 somewhere(SplittableRandom random) {
        Aabb box = world.extent();
        return new Vec3(
                box.minX() + random.nextDouble() * (box.maxX() - box.minX()),
                box.minY() + random.nextDouble() * (box.maxY() - box.minY()),
                box.minZ() + random.nextDouble() * (box.maxZ() - box.minZ()));
    }
}
