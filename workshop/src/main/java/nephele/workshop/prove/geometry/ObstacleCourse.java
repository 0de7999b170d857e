package nephele.workshop.prove.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerInput;

/** A closed yard with obstacles that are difficult to walk on: stairs, a slot, two slopes, an acute wedge, needles. */
public final class ObstacleCourse {
    private final Vec3 origin;
    private final List<Collider> solids = new ArrayList<>();

    private ObstacleCourse(Vec3 origin) {
        this.origin = origin;
    }

    /** Returns the yard with its floor at {@code origin}. */
    public static CollisionWorld at(Vec3 origin) {
        ObstacleCourse yard = new ObstacleCourse(origin);
        yard.walls();
        yard.slope(-9, -5, 35);
        yard.slope(-14, -9, 70);
        yard.box(new Vec3(-7, 0, -3), new Vec3(-6, 3, 3));
        yard.box(new Vec3(-5.39, 0, -3), new Vec3(-4.39, 3, 3));
        for (int i = 0; i < 6; i++) {
            yard.box(new Vec3(2 + 0.3 * i, 0, -2), new Vec3(6, 0.35 * (i + 1), 2));
        }
        yard.needles();
        yard.wedge();
        return new CollisionWorld(yard.solids);
    }

    private void walls() {
        box(new Vec3(-9, -1, -15), new Vec3(8, 0, 7));
        box(new Vec3(-8, 0, -15), new Vec3(7, 4, -14));
        box(new Vec3(-8, 0, 6), new Vec3(7, 4, 7));
        box(new Vec3(-9, 0, -15), new Vec3(-8, 4, 7));
        box(new Vec3(7, 0, -15), new Vec3(8, 4, 7));
    }

    private void needles() {
        for (int i = 0; i < 12; i++) {
            double x = -3 + 0.71 * (i % 4);
            double z = 2 + 0.83 * (i / 4);
            box(new Vec3(x, 0, z), new Vec3(x + 0.01, 0.25 + 0.3 * (i % 3), z + 0.01));
        }
    }

    private void box(Vec3 low, Vec3 high) {
        Aabb box = Aabb.of(List.of(low, high)).moved(origin);
        solids.add(new Collider("solid" + solids.size(), ConvexPolyhedron.box(box)));
    }

    /** Adds a slope eight metres wide that rises towards −z from y = 0 at {@code z1}. */
    private void slope(double z0, double z1, double degrees) {
        double sin = StrictMath.sin(Math.toRadians(degrees));
        double cos = StrictMath.cos(Math.toRadians(degrees));
        planes(List.of(
                plane(new Vec3(0, cos, sin), new Vec3(0, 0, z1)),
                plane(new Vec3(0, 0, -1), new Vec3(0, 0, z0)),
                plane(new Vec3(0, -1, 0), Vec3.ZERO),
                plane(new Vec3(1, 0, 0), new Vec3(4, 0, 0)),
                plane(new Vec3(-1, 0, 0), new Vec3(-4, 0, 0))));
    }

    /** Adds a tapering plate that leans over a corner. */
    private void wedge() {
        planes(List.of(
                plane(new Vec3(-0.9, -0.3, 0.2), new Vec3(5, 0, 4)),
                plane(new Vec3(0.8, 0.35, 0.1), new Vec3(5.6, 0, 4)),
                plane(new Vec3(0, 1, 0), new Vec3(0, 2.5, 0)),
                plane(new Vec3(0, -1, 0), Vec3.ZERO),
                plane(new Vec3(0, 0, 1), new Vec3(0, 0, 5.5)),
                plane(new Vec3(0, 0, -1), new Vec3(0, 0, 2.5))));
    }

    private Plane plane(Vec3 normal, Vec3 through) {
        Plane unit = Plane.of(normal, 0);
        double distance = unit.signedDistance(origin.addScaled(1, through));
        return new Plane(unit.nx(), unit.ny(), unit.nz(), distance);
    }

    private void planes(List<Plane> planes) {
        solids.add(new Collider("solid" + solids.size(), ConvexPolyhedron.fromPlanes(planes)));
    }

    /**
     * Returns the input of a player that tries everything: walks and runs anywhere, turns, and sometimes jumps and
     * crouches.
     */
    public static PlayerInput anything(SplittableRandom random) {
        return new PlayerInput(
                random.nextInt(-1, 2) * 100,
                random.nextInt(-1, 2) * 100,
                random.nextInt(-4000, 4001),
                0,
                random.nextInt(4) == 0 ? random.nextInt(8) : random.nextInt(2));
    }
}
