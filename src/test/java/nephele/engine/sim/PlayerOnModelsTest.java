package nephele.engine.sim;

import static nephele.engine.sim.ModelRoom.rotate;
import static nephele.engine.sim.ModelRoom.scale;
import static nephele.engine.sim.ModelRoom.translate;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Scenarios of players and bodies among models. Forward is −z. */
class PlayerOnModelsTest {
    private static final PlayerInput FORWARD = PlayerInput.FORWARD;
    private static final PlayerInput JUMP = FORWARD.holding(Action.JUMP);

    private static void assertNear(Vec3 expected, Vec3 found, double metres) {
        assertEquals(0, expected.toVector().distance(found.x(), found.y(), found.z()), metres, found::toString);
    }

    /**
     * A box model stops a walk and bears a player that jumps on it and off again, as a solid does, with several meshes.
     */
    @ParameterizedTest
    @ValueSource(strings = {"box_1_1.3d", "box_1_3.3d"})
    void aBoxModelIsABox(String file) {
        ModelRoom solid = new ModelRoom().floor().box(0.2, 0.3, -6, 2, 0.6, 6);
        ModelRoom model = new ModelRoom().floor().model(file, translate(0.2, 0.3, -6) + "," + scale(2, 0.6, 6));
        ModelRoom mirrored = new ModelRoom().floor().model(file, translate(0.2, 0.3, -6) + "," + scale(-2, 0.6, 6));
        for (ModelRoom room : new ModelRoom[] {solid, model, mirrored}) {
            room.hold(FORWARD, 1).hold(JUMP, 0.9);
        }
        assertEquals(0.6, solid.feet().y(), 1e-6);
        assertNear(solid.feet(), model.feet(), 1e-9);
        assertNear(solid.feet(), mirrored.feet(), 1e-9);
        for (ModelRoom room : new ModelRoom[] {solid, model, mirrored}) {
            room.hold(FORWARD, 2);
        }
        assertEquals(0, solid.feet().y(), 1e-6);
        assertNear(solid.feet(), model.feet(), 1e-9);
        assertNear(solid.feet(), mirrored.feet(), 1e-9);
    }

    /** A plane model of many triangles is as level and as fast to walk on as a floor. */
    @ParameterizedTest
    @ValueSource(strings = {"plane_40_1.3d", "plane_40_67.3d"})
    void aPlaneModelIsAFloor(String file) {
        ModelRoom floor = new ModelRoom().floor().startAt(0.3, 0.5, 5).hold(PlayerInput.NONE, 1);
        ModelRoom plane = new ModelRoom().model(file, "").startAt(0.3, 0.5, 5).hold(PlayerInput.NONE, 1);
        plane.hold(FORWARD, 3, state -> {
            assertEquals(0, state.player().feet().y(), 1e-6);
            assertTrue(state.player().isGrounded());
        });
        assertNear(floor.hold(FORWARD, 3).feet(), plane.feet(), 1e-6);
    }

    @Test
    void walksUpARampModel() {
        ModelRoom ramp =
                new ModelRoom().floor().model("plane_8_5.3d", translate(0, 0, -5) + "," + rotate("[1, 0, 0]", 20));
        ramp.hold(FORWARD, 1.5);
        double[] last = {-1};
        ramp.hold(FORWARD, 0.6, state -> {
            assertTrue(
                    state.player().isGrounded(),
                    () -> "in the air at " + state.player().feet());
            assertTrue(
                    state.player().feet().y() > last[0],
                    () -> "held up at " + state.player().feet());
            last[0] = state.player().feet().y();
        });
        double z = ramp.feet().z();
        assertEquals(
                StrictMath.tan(StrictMath.toRadians(20)) * (-5 - z), ramp.feet().y(), 0.05);
    }

    /**
     * No fall passes through a sheet, from a height at which a tick's displacement exceeds the sheet's thickness, fifty
     * times.
     */
    @Test
    void nobodyFallsThroughASheet() {
        ModelRoom room = new ModelRoom()
                .model("plane_40_9.3d", "")
                .startAt(0.3, 500, 0.2)
                .cube(3.2, 400, 1.1, 0.5);
        room.hold(PlayerInput.NONE, 20);
        assertEquals(0, room.feet().y(), 1e-6);
        assertEquals(0.25, room.body(0).y(), 2e-3);
    }

    /** Cubes rest on meshes as on solids, also across the edges of triangles. */
    @Test
    void bodiesRestOnModels() {
        ModelRoom room = new ModelRoom()
                .floor()
                .model("plane_4_7.3d", translate(0, 1, -4))
                .model("torus_1_0.4_24_12.3d", translate(5, 0.4, -4))
                .model("sphere_0.8_8_8.3d", translate(-5, 0.8, -4))
                .cube(0.1, 1.6, -4.2, 0.5)
                .cube(5, 0.9, -3, 0.3)
                .cube(-5, 2.1, -4, 0.5);
        room.hold(PlayerInput.NONE, 4);
        assertNear(new Vec3(0.1, 1.25, -4.2), room.body(0), 2e-3);
        assertTrue(room.body(1).y() > 0.14 && room.body(1).y() < 1, "on the torus or beside it: " + room.body(1));
        assertTrue(room.body(2).y() > 0.24, "on the ball or beside it: " + room.body(2));
    }

    @Test
    void aShotOpensAPortalOnAPlaneModel() {
        String upright = "," + rotate("[1, 0, 0]", 90);
        ModelRoom room = new ModelRoom()
                .floor()
                .model("plane_6_8.3d", translate(0, 2, -6) + upright, ", \"portalable\": true")
                .model("plane_6_8.3d", translate(0, 2, 6) + rotateAround(), ", \"portalable\": true")
                .gun()
                .startAt(0, 0, 0);
        room.hold(PlayerInput.NONE, 0.2)
                .turn(0, -5)
                .press(Action.FIRE_FIRST)
                .turn(180, 0)
                .press(Action.FIRE_SECOND)
                .turn(180, 0);
        assertEquals(2, room.state().world().portals().size());
        assertEquals(-6, room.state().world().portals().portal(0).centre().z(), 1e-6);
        assertEquals(6, room.state().world().portals().portal(1).centre().z(), 1e-6);
        room.hold(FORWARD, 2);
        assertTrue(room.feet().z() > 0, "came out behind: " + room.feet());
    }

    private static String rotateAround() {
        return "," + rotate("[0, 1, 0]", 180) + "," + rotate("[1, 0, 0]", 90);
    }

    @Test
    void noPortalOpensOnAModelThatTakesNone() {
        ModelRoom room = new ModelRoom()
                .floor()
                .model("plane_6_8.3d", translate(0, 2, -6) + "," + rotate("[1, 0, 0]", 90))
                .gun();
        room.hold(PlayerInput.NONE, 0.2).press(Action.FIRE_FIRST);
        assertEquals(0, room.state().world().portals().size());
    }
}
