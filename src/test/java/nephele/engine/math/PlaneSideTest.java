package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class PlaneSideTest {
    /** The sign is BigDecimal's on 10⁵ near-degenerate points, where rounding is often wrong. */
    @Test
    void theExactSideIsThatOfBigDecimal() {
        var random = new SplittableRandom(18);
        int roundedWrongly = 0;
        for (int i = 0; i < 100_000; i++) {
            double x = step(random) * (i % 3 == 0 ? 1e6 : 1);
            double y = step(random);
            double z = step(random);
            Vec3 normal = BasisTest.randomDirection(random);
            Plane through = Plane.of(normal, 0);
            double distance = through.nx() * x + through.ny() * y + through.nz() * z;
            Plane plane = new Plane(
                    through.nx(), through.ny(), through.nz(), distance + random.nextInt(-2, 3) * Math.ulp(distance));
            int sign = exactSign(plane, x, y, z);
            assertEquals(sign, PlaneSide.exactlyOf(plane, x, y, z).ordinal() - 1, plane::toString);
            roundedWrongly += Math.signum(plane.signedDistance(x, y, z)) == sign ? 0 : 1;
        }
        assertTrue(roundedWrongly > 1000, "the points are too easy: rounding failed " + roundedWrongly + " times");
    }

    private static double step(SplittableRandom random) {
        return random.nextDouble(-10, 10);
    }

    private static int exactSign(Plane plane, double x, double y, double z) {
        return new BigDecimal(plane.nx())
                .multiply(new BigDecimal(x))
                .add(new BigDecimal(plane.ny()).multiply(new BigDecimal(y)))
                .add(new BigDecimal(plane.nz()).multiply(new BigDecimal(z)))
                .subtract(new BigDecimal(plane.distance()))
                .signum();
    }

    @Test
    void aThickPlaneHoldsWhatIsWithinRoundingOfIt() {
        Plane floor = new Plane(0, 1, 0, 2);
        assertEquals(PlaneSide.ON, PlaneSide.ofThick(floor, new Vec3(0, 2 + 0.9e-5, 0), 0.1));
        assertEquals(PlaneSide.IN_FRONT, PlaneSide.ofThick(floor, new Vec3(0, 2 + 1.1e-5, 0), 0.1));
        assertEquals(PlaneSide.BEHIND, PlaneSide.ofThick(floor, new Vec3(0, 2 - 1.1e-5, 0), 0.1));
        assertEquals(PlaneSide.ON, PlaneSide.ofThick(floor, new Vec3(0, 2 - 0.9e-3, 0), 100));
        assertEquals(PlaneSide.ON, PlaneSide.exactlyOf(floor, 1e300, 2, -1e300));
    }
}
