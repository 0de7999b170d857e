package nephele.workshop.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.workshop.prove.bodies.BoxPile;
import nephele.workshop.prove.bodies.EnergyLedger;
import nephele.workshop.prove.bodies.EnergyLimits;
import nephele.workshop.prove.bodies.EnergyProof;
import nephele.workshop.prove.proof.Proof;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A plate and a thin rod, each of 50 kg, in a closed room of 12 m, do not exceed the speed of their fall; at tick 503
 * they once moved at 402 km/s.
 */
@Execution(ExecutionMode.CONCURRENT)
class ThinBodiesTest {
    private static final int RATE = 120;
    /** The sum of both heights, as if one body had the potential energy of both. */
    private static final double FALL_METRES = 1.6 + 3.95;

    @Test
    void aPlateAndARodFallNoFasterThanTheirHeightGives() {
        BodyTable table = new BodyTable(List.of(
                body("plate", new Vec3(-.1215, 1.6, -.0196), new Vec3(.05, 2.5, 2.5)),
                body("rod", new Vec3(-.1195, 3.95, .0594), new Vec3(.001, 1.5, .001))));
        RigidStep step = new RigidStep(table, new Vec3(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0));
        PortalWorld room = PortalWorld.of(BoxPile.closedRoom(6, 12, 1));
        EnergyLedger ledger = new EnergyLedger(table, Portals.NONE, 1.0 / RATE);
        EnergyLimits bars = new EnergyLimits(table);
        double most = Math.sqrt(2 * PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED * FALL_METRES);
        Bodies bodies = table.start();
        bars.start(ledger.joules(bodies));
        for (int tick = 1; tick <= 10 * RATE; tick++) {
            bodies = step.step(bodies, room, BodyInfluences.none(), 1.0 / RATE);
            bars.record(tick, ledger.joules(bodies));
            for (int i = 0; i < bodies.size(); i++) {
                double speed = bodies.velocity(i, new Vector3d()).length();
                assertTrue(speed <= most, table.body(i).id() + " at " + speed + " m/s at tick " + tick);
            }
        }
        assertFalse(bars.gains(), () -> bars.failure().orElseThrow());
    }

    /**
     * Piles that once sank, gained energy or rocked forever are right: needles and plates across each other (581, 595,
     * 2293), long bodies that slide along a portal's rim (2163, 2526, 2970, 3498, 3735), one jammed in the rim (3765),
     * a capsule that hovers in a portal (3846), a plate with a far end that hit before it was tested (86545), a box in
     * a corner with an alternating friction (204096), a plank pushed out of the wrong side of a rim (202659), capsules
     * that climbed over a plank's edge (200203, 207215).
     */
    @ParameterizedTest
    @ValueSource(
            longs = {581, 595, 2163, 2293, 2526, 2970, 3498, 3735, 3765, 3846, 86545, 200203, 202659, 204096, 207215})
    void pilesThatOnceFailed(long number) {
        assertEquals(
                List.of(), new EnergyProof().run(number, 1, Proof.Progress.NONE).examples());
    }

    private static Body body(String id, Vec3 centre, Vec3 size) {
        return new Body.Box(id, centre, size, 50, null, .6, 0);
    }
}
