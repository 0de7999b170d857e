package nephele.workshop.prove.bodies;

import java.util.Locale;
import java.util.SplittableRandom;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.Body;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;

/**
 * A box, ball or capsule of random size, mass, orientation and motion, placed at the origin.
 *
 * @param start upright for half of the bodies, at rest for three quarters
 */
record DroppedBody(Body body, BodyState start) {
    private static final double LEAST_EDGE_METRES = .001;
    private static final double MOST_EDGE_METRES = 2.5;
    private static final double LEAST_KILOGRAMS = .001;
    private static final double MOST_KILOGRAMS = 1000;
    private static final double MOST_METRES_PER_SECOND = 5;
    private static final double MOST_RADIANS_PER_SECOND = 10;
    private static final double FRICTION = .6;

    static DroppedBody of(SplittableRandom random, int index) {
        Body body = body(random, "b" + index, DroppedPile.logUniform(random, LEAST_KILOGRAMS, MOST_KILOGRAMS));
        Quaterniond turn = random.nextBoolean()
                ? new Quaterniond()
                : Rotations.aroundAxis(direction(random), random.nextDouble(0, Math.PI));
        boolean moves = random.nextInt(4) == 0;
        Vec3 velocity = moves ? upTo(random, MOST_METRES_PER_SECOND) : Vec3.ZERO;
        Vec3 spin = moves ? upTo(random, MOST_RADIANS_PER_SECOND) : Vec3.ZERO;
        return new DroppedBody(body, new BodyState(Vec3.ZERO, turn, velocity, spin));
    }

    private static Body body(SplittableRandom random, String id, double kilograms) {
        return switch (random.nextInt(3)) {
            case 0 ->
                new Body.Box(
                        id,
                        Vec3.ZERO,
                        new Vec3(edge(random), edge(random), edge(random)),
                        kilograms,
                        null,
                        FRICTION,
                        0);
            case 1 -> new Body.Sphere(id, Vec3.ZERO, edge(random) / 2, kilograms, null, FRICTION, 0);
            default -> {
                double diameter = edge(random);
                double height = DroppedPile.logUniform(random, diameter, MOST_EDGE_METRES);
                yield new Body.Capsule(id, Vec3.ZERO, diameter / 2, height, kilograms, null, FRICTION, 0);
            }
        };
    }

    private static double edge(SplittableRandom random) {
        return DroppedPile.logUniform(random, LEAST_EDGE_METRES, MOST_EDGE_METRES);
    }

    private static Vec3 upTo(SplittableRandom random, double most) {
        return direction(random).scaled(random.nextDouble(0, most));
    }

    /** Returns a direction, uniform over the sphere: height and longitude are uniform. */
    private static Vec3 direction(SplittableRandom random) {
        double y = random.nextDouble(-1, 1);
        double longitude = random.nextDouble(0, 2 * Math.PI);
        double r = Math.sqrt(1 - y * y);
        return new Vec3(r * StrictMath.cos(longitude), y, r * StrictMath.sin(longitude));
    }

    static String inWords(Body body) {
        String shape;
        if (body instanceof Body.Box box) {
            shape = String.format(
                    Locale.ROOT,
                    "box %.4f x %.4f x %.4f m",
                    box.size().x(),
                    box.size().y(),
                    box.size().z());
        } else if (body instanceof Body.Capsule capsule) {
            shape = String.format(
                    Locale.ROOT, "capsule %.4f x %.4f m", 2 * capsule.radiusMetres(), capsule.heightMetres());
        } else {
            shape = String.format(Locale.ROOT, "ball %.4f m", 2 * ((Body.Sphere) body).radiusMetres());
        }
        return String.format(Locale.ROOT, "%s %.3g kg", shape, body.massKilograms());
    }
}
