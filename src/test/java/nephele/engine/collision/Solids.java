package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** Random solids for tests: boxes, needles, plates and tilted convex ones, around the origin. */
final class Solids {
    private Solids() {}

    static ConvexPolyhedron any(SplittableRandom random) {
        return switch (random.nextInt(4)) {
            case 0 -> box(size(random), size(random), size(random));
            case 1 -> box(0.001 + 0.01 * random.nextDouble(), 4, 0.01);
            case 2 -> box(6, 0.001 + 0.01 * random.nextDouble(), 6);
            default -> tilted(random);
        };
    }

    static ConvexPolyhedron box(double x, double y, double z) {
        return ConvexPolyhedron.box(Aabb.around(Vec3.ZERO, new Vec3(x, y, z)));
    }

    private static double size(SplittableRandom random) {
        return 0.05 + 4 * random.nextDouble();
    }

    private static ConvexPolyhedron tilted(SplittableRandom random) {
        List<Plane> planes = new ArrayList<>();
        for (ConvexPolyhedron.Face face :
                box(size(random), size(random), size(random)).faces()) {
            planes.add(face.plane());
        }
        for (int i = 1 + random.nextInt(5); i > 0; i--) {
            Vector3d normal = direction(random);
            planes.add(new Plane(normal.x, normal.y, normal.z, 0.02 + random.nextDouble()));
        }
        return ConvexPolyhedron.fromPlanes(planes);
    }

    static Vector3d direction(SplittableRandom random) {
        while (true) {
            Vector3d v = point(random, 1);
            if (v.lengthSquared() > 0.01 && v.lengthSquared() <= 1) {
                return v.normalize();
            }
        }
    }

    static Vector3d point(SplittableRandom random, double reach) {
        return new Vector3d(
                reach * (2 * random.nextDouble() - 1),
                reach * (2 * random.nextDouble() - 1),
                reach * (2 * random.nextDouble() - 1));
    }

    static CollisionWorld world(ConvexPolyhedron... shapes) {
        List<Collider> colliders = new ArrayList<>();
        for (ConvexPolyhedron shape : shapes) {
            colliders.add(new Collider("solid" + colliders.size(), shape));
        }
        return new CollisionWorld(colliders);
    }
}
