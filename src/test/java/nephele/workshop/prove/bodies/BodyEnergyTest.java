package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.function.Predicate;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.Body;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The kinetic energy equals the sum of m v² / 2 over small cells of the body. */
class BodyEnergyTest {
    private static final int CELLS = 60;
    private static final Vec3 VELOCITY = new Vec3(1, -2, 3);
    private static final Vec3 SPIN = new Vec3(4, 5, -6);
    private static final Quaterniond TURN = Rotations.aroundAxis(new Vec3(1, 2, -1), 1.1);

    @Test
    void boxes() {
        Body box = new Body.Box("b", Vec3.ZERO, new Vec3(.4, 1, 2), 3, null, 0, 0);
        check(box, new Vector3d(.2, .5, 1), p -> true);
    }

    @Test
    void balls() {
        Body ball = new Body.Sphere("b", Vec3.ZERO, .7, 3, null, 0, 0);
        check(ball, new Vector3d(.7), p -> p.length() < .7);
    }

    @Test
    void capsules() {
        Body capsule = new Body.Capsule("b", Vec3.ZERO, .3, 1.4, 3, null, 0, 0);
        check(capsule, new Vector3d(.3, .7, .3), p -> {
            double beyond = Math.max(0, Math.abs(p.y) - .4);
            return p.x * p.x + p.z * p.z + beyond * beyond < .09;
        });
    }

    private static void check(Body body, Vector3d half, Predicate<Vector3d> holds) {
        Bodies bodies = Bodies.of(List.of(new BodyState(Vec3.ZERO, TURN, VELOCITY, SPIN)));
        assertEquals(summed(body, half, holds), new BodyEnergy().kinetic(body, bodies, 0), .3);
    }

    private static double summed(Body body, Vector3d half, Predicate<Vector3d> holds) {
        double squares = 0;
        int count = 0;
        for (int i = 0; i < CELLS * CELLS * CELLS; i++) {
            Vector3d p =
                    new Vector3d(middle(i % CELLS), middle(i / CELLS % CELLS), middle(i / CELLS / CELLS)).mul(half);
            if (holds.test(p)) {
                TURN.transform(p);
                squares += SPIN.toVector().cross(p).add(VELOCITY.toVector()).lengthSquared();
                count++;
            }
        }
        return body.massKilograms() / 2 * squares / count;
    }

    private static double middle(int cell) {
        return (cell + .5) / CELLS * 2 - 1;
    }
}
