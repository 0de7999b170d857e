package nephele.engine.cloud.drawn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import nephele.engine.cloud.drawn.CloudPuffs.Puff;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

class PuffSlabsTest {
    private static final Vec3 EYE = new Vec3(30, 20, 10);

    private static CloudPuffs heap() {
        var random = new Random(2);
        List<Puff> all = new ArrayList<>();
        for (int i = 0; i < 200; i++) {
            Vec3 centre = new Vec3(
                    800 * random.nextDouble() - 400, 300 * random.nextDouble(), -2000 - 900 * random.nextDouble());
            all.add(new Puff(centre, 40 + 20 * random.nextDouble(), 0.05));
        }
        return new CloudPuffs(all);
    }

    @Test
    void everyBallIsInOneSlabTheFarthestFirst() {
        PuffSlabs slabs = PuffSlabs.of(heap(), EYE, 1e-3).orElseThrow();
        assertEquals(4, slabs.slabs().size());
        assertEquals(new HashSet<>(heap().all()), new HashSet<>(slabs.puffs()));
        int next = 0;
        double before = Double.POSITIVE_INFINITY;
        for (PuffSlabs.Slab slab : slabs.slabs()) {
            assertEquals(next, slab.first());
            next = slab.end();
            assertTrue(slab.near() < slab.middle() && slab.middle() < slab.far() && slab.middle() < before);
            before = slab.middle();
            for (int ball = slab.first() + 1; ball < slab.end(); ball++) {
                assertTrue(
                        metres(slabs.puffs().get(ball)) <= metres(slabs.puffs().get(ball - 1)));
            }
        }
        assertEquals(200, next);
    }

    private static double metres(Puff ball) {
        return ball.centre().minus(EYE).length();
    }

    /** Every ball's centre is in the picture of its slab where another eye sees it, but for the error. */
    @Test
    void noBallIsFartherFromItsPlaceThanTheError() {
        PuffSlabs slabs = PuffSlabs.of(heap(), EYE, 1e-3).orElseThrow();
        assertEquals(0, slabs.errorRadians(EYE), 1e-12);
        for (Vec3 step : List.of(new Vec3(20, 0, 0), new Vec3(0, -15, 0), new Vec3(3, 2, -60), new Vec3(-9, 4, 40))) {
            Vec3 eye = EYE.plus(step);
            double error = slabs.errorRadians(eye);
            double worst = 0;
            for (PuffSlabs.Slab slab : slabs.slabs()) {
                for (Puff ball : slabs.puffs().subList(slab.first(), slab.end())) {
                    Vec3 to = ball.centre().minus(EYE);
                    Vec3 shown =
                            EYE.addScaled(slab.middle() / -to.dot(slabs.axes().back()), to);
                    worst = Math.max(
                            worst, angle(shown.minus(eye), ball.centre().minus(eye)));
                }
            }
            assertTrue(worst <= error && error < 2 * worst, "worst " + worst + ", error " + error);
        }
    }

    private static double angle(Vec3 a, Vec3 b) {
        return Math.atan2(a.cross(b).length(), a.dot(b));
    }

    /** A picture of one slab: Harris' error is the angle between both ends, of which half is above the middle. */
    @Test
    void theErrorOfOneBallIsThatOfItsDepth() {
        var ball = new CloudPuffs(List.of(new Puff(new Vec3(0, 0, -2000), 300, 0.05)));
        PuffSlabs slabs = PuffSlabs.of(ball, Vec3.ZERO, 1e-3).orElseThrow();
        double t = 6.3;
        double betweenEnds = 2 * 300 * t / (2000.0 * 2000 - 300.0 * 300);
        assertEquals(betweenEnds / 2, slabs.errorRadians(new Vec3(t, 0, 0)), 0.05 * betweenEnds);
    }

    @Test
    void fromInsideThereIsNoPicture() {
        assertTrue(PuffSlabs.of(heap(), new Vec3(0, 150, -2400), 1e-3).isEmpty());
        assertTrue(PuffSlabs.of(heap(), new Vec3(0, 150, -1800), 1e-3).isEmpty());
        assertTrue(PuffSlabs.of(new CloudPuffs(List.of(new Puff(new Vec3(0, 0, -2000), 300, 0))), EYE, 1e-3)
                .isEmpty());
    }
}
