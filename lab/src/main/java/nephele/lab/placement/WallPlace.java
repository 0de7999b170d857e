package nephele.lab.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/** The placement of a random wall: its x, y and height above it as positions, and a view of it. */
public record WallPlace(Vec3 origin, Vec3 right, Vec3 up, Vec3 normal) {
    /**
     * Returns an upright, level or downward-facing wall, or one at least 30° from level; near the origin, or up to 10
     * km away.
     */
    static WallPlace random(SplittableRandom random) {
        double far = random.nextInt(4) == 0 ? 1e4 : 20;
        Vec3 origin =
                new Vec3(random.nextDouble(-far, far), random.nextDouble(-far, far), random.nextDouble(-far, far));
        Vec3 normal = normal(random);
        Vec3 side = Directions.perpendicular(normal);
        double spin = random.nextInt(2) == 0 ? 0 : random.nextDouble(-3, 3);
        Vec3 across = normal.cross(side);
        Vec3 right = sum(side, Math.cos(spin), across, Math.sin(spin));
        return new WallPlace(origin, right, normal.cross(right), normal);
    }

    private static Vec3 normal(SplittableRandom random) {
        double turn = random.nextInt(2) == 0 ? 0 : random.nextDouble(-3, 3);
        double rise =
                switch (random.nextInt(5)) {
                    case 0 -> 1;
                    case 1 -> -1;
                    case 2 -> 0;
                    default -> random.nextDouble(-0.85, 0.85);
                };
        double level = Math.sqrt(1 - rise * rise);
        return Directions.unit(level * Math.sin(turn), rise, level * Math.cos(turn));
    }

    private static Vec3 sum(Vec3 a, double ofA, Vec3 b, double ofB) {
        return Directions.unit(Directions.combined(a, ofA, b, ofB));
    }

    /** Returns the position of a point of the wall's frame. */
    public Vec3 world(double x, double y, double height) {
        return new Vec3(
                origin.x() + x * right.x() + y * up.x() + height * normal.x(),
                origin.y() + x * right.y() + y * up.y() + height * normal.y(),
                origin.z() + x * right.z() + y * up.z() + height * normal.z());
    }

    /** Returns a position's x in the wall's frame, metres. */
    public double x(Vec3 p) {
        return right.dot(fromOrigin(p));
    }

    /** Returns a position's y in the wall's frame, metres. */
    public double y(Vec3 p) {
        return up.dot(fromOrigin(p));
    }

    /** Returns a position's height above the wall, metres. */
    public double height(Vec3 p) {
        return normal.dot(fromOrigin(p));
    }

    private Vec3 fromOrigin(Vec3 p) {
        return p.minus(origin);
    }

    /** Returns a prism over a convex counter-clockwise polygon, from one height to another. */
    Brush prism(double[] polygon, double low, double high, boolean portalable) {
        List<Solid.PlaneFace> planes = new ArrayList<>();
        planes.add(plane(normal, world(0, 0, high), portalable));
        planes.add(plane(normal.negated(), world(0, 0, low), portalable));
        for (int i = 0; i < polygon.length; i += 2) {
            int j = (i + 2) % polygon.length;
            double dx = polygon[j] - polygon[i];
            double dy = polygon[j + 1] - polygon[i + 1];
            Vec3 out = sum(right, dy, up, -dx);
            planes.add(plane(out, world(polygon[i], polygon[i + 1], 0), portalable));
        }
        return Brush.of(new Solid.Planes("s", null, portalable, TextureMapping.WORLD, planes));
    }

    private static Solid.PlaneFace plane(Vec3 normal, Vec3 through, boolean portalable) {
        return new Solid.PlaneFace(normal, normal.dot(through), null, portalable, null);
    }

    /** Returns a view along a direction without roll; straight up or down with any yaw. */
    public static Basis looking(Vec3 direction, double yaw) {
        if (Math.abs(direction.y()) > 1 - 1e-9) {
            return Basis.ofYawPitch(yaw, direction.y() > 0 ? Math.PI / 2 : -Math.PI / 2);
        }
        return Basis.lookAt(Vec3.ZERO, direction, new Vec3(0, 1, 0), Basis.WORLD);
    }

    /** Returns the portal's up: up along a slope, ahead of the view on level surfaces. */
    public Vec3 expectedUp(Basis view) {
        if (Math.abs(normal.y()) < 0.86) {
            Vec3 across = new Vec3(0, 1, 0).cross(normal);
            Vec3 along = across.cross(normal);
            return Directions.unit(
                    Math.signum(along.y()) * along.x(), Math.abs(along.y()), Math.signum(along.y()) * along.z());
        }
        Vec3 forward = view.back().negated();
        // If the view is straight down, its up vector points ahead; if straight up, the opposite.
        Vec3 ahead = Math.abs(forward.y()) > 1 - 1e-9
                ? new Vec3(
                        -forward.y() * view.up().x(),
                        0,
                        -forward.y() * view.up().z())
                : forward;
        return Directions.unit(ahead.x(), 0, ahead.z());
    }
}
