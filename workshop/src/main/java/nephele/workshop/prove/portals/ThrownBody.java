package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * A box, ball or capsule of random size.
 *
 * @param points of its surface relative to its centre, before any rotation
 */
record ThrownBody(Body body, List<Vector3d> points) {
    private static final double MIN_HALF_METRES = 0.1;
    private static final double MAX_HALF_METRES = 0.4;

    /** Returns a ball (one in four), a capsule (one in four) or a box; two in three boxes are cubes. */
    static ThrownBody of(SplittableRandom random) {
        double half = random.nextDouble(MIN_HALF_METRES, MAX_HALF_METRES);
        return switch (random.nextInt(4)) {
            case 0 -> ball(half);
            case 1 -> capsule(half, random.nextDouble(0, 2 * MAX_HALF_METRES));
            default -> box(half, random.nextInt(3) > 0 ? half : random.nextDouble(MIN_HALF_METRES, MAX_HALF_METRES));
        };
    }

    private static ThrownBody box(double half, double depth) {
        Vec3 size = new Vec3(2 * half, 2 * half, 2 * depth);
        return new ThrownBody(
                new Body.Box("box", Vec3.ZERO, size, 10, null, 0.6, 0.2), onBox(new Vec3(half, half, depth)));
    }

    private static ThrownBody ball(double radius) {
        return new ThrownBody(new Body.Sphere("ball", Vec3.ZERO, radius, 10, null, 0.6, 0.4), onBall(radius));
    }

    /** @param straight metres between the centres of its caps */
    private static ThrownBody capsule(double radius, double straight) {
        List<Vector3d> points = new ArrayList<>();
        for (Vector3d point : onBall(radius)) {
            points.add(new Vector3d(point).add(0, straight / 2, 0));
            points.add(new Vector3d(point).sub(0, straight / 2, 0));
        }
        double height = straight + 2 * radius;
        return new ThrownBody(new Body.Capsule("capsule", Vec3.ZERO, radius, height, 10, null, 0.6, 0.2), points);
    }

    private static List<Vector3d> onBox(Vec3 half) {
        List<Vector3d> points = new ArrayList<>();
        for (int i = 0; i < 27; i++) {
            if (i != 13) {
                points.add(new Vector3d((i % 3 - 1) * half.x(), (i / 3 % 3 - 1) * half.y(), (i / 9 - 1) * half.z()));
            }
        }
        return points;
    }

    private static List<Vector3d> onBall(double radius) {
        List<Vector3d> points = onBox(new Vec3(1, 1, 1));
        points.forEach(point -> point.normalize(radius));
        return points;
    }
}
