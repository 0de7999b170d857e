package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

class EnergyLimitsTest {
    /** The bodies have a mass of two kilograms: a centimetre is 0.1962 J, a millimetre a tenth of it. */
    private final EnergyLimits bars = new EnergyLimits(new BodyTable(List.of(ball("a"), ball("b"))));

    private static Body ball(String id) {
        return new Body.Sphere(id, Vec3.ZERO, 1, 1, null, 0, 0);
    }

    @Test
    void aGainIsMeasuredFromTheLeastBefore() {
        bars.start(100);
        bars.record(1, 50);
        bars.record(2, 50 + .001 + .0196);
        assertFalse(bars.gainsLittle());
        bars.record(3, 50 + .001 + .0197);
        assertTrue(bars.gainsLittle());
        bars.record(4, 50 + .001 + .1961);
        assertFalse(bars.gains());
        bars.record(5, 50 + .001 + .1963);
        assertTrue(bars.gains());
        assertEquals(.1963 / .1962 / 100, bars.mostLiftedMetres(), 1e-9);
        assertTrue(bars.failure().orElseThrow().contains("1 cm at tick 5"));
    }

    @Test
    void whatIsNoNumberIsAGain() {
        bars.start(1);
        bars.record(1, Double.NaN);
        assertTrue(bars.gains());
    }

    @Test
    void whatOnlyFallsGainsNothing() {
        bars.start(3);
        bars.record(1, 2);
        bars.record(2, -40);
        assertFalse(bars.gainsLittle());
        assertTrue(bars.failure().isEmpty());
    }
}
