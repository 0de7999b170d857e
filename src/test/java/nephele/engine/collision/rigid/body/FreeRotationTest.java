package nephele.engine.collision.rigid.body;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class FreeRotationTest {
    /** A freely rotating body keeps its angular momentum, and its energy within 1e-3, however thin it is. */
    @ParameterizedTest
    @CsvSource({
        "1, 1, 1, 20",
        "1, 0.6, 0.3, 15",
        "0.05, 2.5, 2.5, 30",
        "0.001, 1.5, 0.001, 400",
        "0.001, 0.05, 2.5, 60",
        "2.5, 0.001, 0.0012, 3000",
        "0.001, 0.0011, 2.5, 3000"
    })
    void keepsMomentumAndEnergy(double x, double y, double z, double speed) {
        BodyTable table = new BodyTable(List.of(new Body.Box("b", Vec3.ZERO, new Vec3(x, y, z), 3, null, 0, 0)));
        double[] motion = new double[Bodies.STRIDE];
        motion[Bodies.ORIENTATION + 3] = 1;
        Vector3d axis = new Vector3d(0.5, -0.3, 0.8).normalize().mul(speed);
        motion[Bodies.SPIN] = axis.x;
        motion[Bodies.SPIN + 1] = axis.y;
        motion[Bodies.SPIN + 2] = axis.z;
        Vector3d momentum = momentum(motion, table);
        double energy = energy(motion, table);
        FreeRotation freeRotation = new FreeRotation();
        for (int tick = 0; tick < 2000; tick++) {
            freeRotation.turn(motion, 0, 1 / 120.0, table, 0);
            assertEquals(0, momentum.distance(momentum(motion, table)), 1e-9 * momentum.length(), "tick " + tick);
            assertEquals(energy, energy(motion, table), 1e-3 * energy, "tick " + tick);
        }
    }

    /**
     * The motion of a rod's axis depends only on the momentum perpendicular to it, however fast it spins about itself.
     */
    @ParameterizedTest
    @CsvSource({"0", "10", "10000"})
    void aRodTurnsByTheSpinAcrossIt(double about) {
        BodyTable table =
                new BodyTable(List.of(new Body.Box("b", Vec3.ZERO, new Vec3(1, 0.001, 0.001), 3, null, 0, 0)));
        double[] motion = new double[Bodies.STRIDE];
        motion[Bodies.ORIENTATION + 3] = 1;
        motion[Bodies.SPIN] = about;
        motion[Bodies.SPIN + 1] = 2;
        for (int tick = 0; tick < 120; tick++) {
            new FreeRotation().turn(motion, 0, 1 / 120.0, table, 0);
        }
        Vector3d end = orientation(motion).transform(new Vector3d(1, 0, 0));
        // The momentum along the rod is a millionth of its spin: at 10 000 rad/s it bends the path by a hundredth.
        assertEquals(0, end.distance(Math.cos(2), 0, -Math.sin(2)), about < 100 ? 1e-4 : 0.02);
    }

    private static Quaterniond orientation(double[] m) {
        int q = Bodies.ORIENTATION;
        return new Quaterniond(m[q], m[q + 1], m[q + 2], m[q + 3]);
    }

    private static Vector3d local(double[] m) {
        Vector3d freeRotation = new Vector3d(m[Bodies.SPIN], m[Bodies.SPIN + 1], m[Bodies.SPIN + 2]);
        return orientation(m).transformInverse(freeRotation);
    }

    private static Vector3d momentum(double[] m, BodyTable table) {
        Vector3d l = local(m);
        l.set(l.x / table.inverseInertia(0, 0), l.y / table.inverseInertia(0, 1), l.z / table.inverseInertia(0, 2));
        return orientation(m).transform(l);
    }

    private static double energy(double[] m, BodyTable table) {
        Vector3d l = local(m);
        return (l.x * l.x / table.inverseInertia(0, 0)
                        + l.y * l.y / table.inverseInertia(0, 1)
                        + l.z * l.z / table.inverseInertia(0, 2))
                / 2;
    }
}
