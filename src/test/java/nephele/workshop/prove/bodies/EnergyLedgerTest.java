package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EnergyLedgerTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    /**
     * A ball falls into the floor and leaves a wall 2.5 m higher: the gain of height is due to the passage, not to the
     * body.
     */
    @ParameterizedTest
    @ValueSource(ints = {7, 20, 120, 1000})
    void aFlightThroughPortalsKeepsTheBookedEnergy(int rate) {
        Aperture aperture = Aperture.of(PortalShape.RECTANGLE, 1.2, 2.1);
        Portal floor = new Portal("a", Vec3.ZERO, Portal.facing(UP, new Vec3(1, 0, 0)), aperture);
        Portal wall = new Portal("b", new Vec3(-6, 2.5, 0), Portal.facing(new Vec3(1, 0, 0), UP), aperture);
        Portals portals = new Portals(List.of(floor, wall), List.of(1, 0));
        PortalWorld world = PortalWorld.of(BoxPile.closedRoom(6, 6, 1), portals);
        BodyTable table = new BodyTable(List.of(new Body.Sphere("ball", Vec3.ZERO, .05, 2, null, 0, 0)));
        RigidStep step = new RigidStep(table, new Vec3(0, -9.81, 0));
        EnergyLedger ledger = new EnergyLedger(table, portals, 1.0 / rate);
        Bodies bodies = Bodies.of(
                List.of(BodyState.resting(new Vec3(.3, 1.7, .1)).moving(new Vec3(.4, 0, .2), new Vec3(1, 2, 3))));
        double first = ledger.joules(bodies);
        for (int tick = 0; tick < rate; tick++) {
            Bodies next = step.step(bodies, world, BodyInfluences.none(), 1.0 / rate);
            ledger.book(bodies, next);
            assertEquals(first, ledger.joules(next), 1e-9 * first, "tick " + tick);
            bodies = next;
        }
        assertEquals(1, ledger.crossings());
        assertTrue(bodies.centre(0, new Vector3d()).x < -1, "it came out of the wall");
    }
}
