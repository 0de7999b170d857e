package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalShape;
import nephele.engine.level.Terrain;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.scene.FrameState;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.GunPortals.Colour;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.host.playthrough.CrosshairState.Shot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Previews over a terrain that is uneven by 8 mm for x < 0 and by 30 mm for x > 0. The player looks to the north. */
class ShotPreviewsTest {
    private static final int SIDE = 61;
    private static final PlayerInput RIGHT = PlayerInput.NONE.turning(-90_000, 0);

    private Simulation simulation;
    private ShotPreviews previews;
    private SimState state;

    ShotPreviewsTest() {
        start();
    }

    private void start(Body... bodies) {
        var map = TestTerrain.map(SIDE, (column, row) -> {
            double metres = (column < SIDE / 2 ? 0.008 : 0.03) * ((column + row) % 2 == 0 ? 1 : -1);
            return (int) Math.round(65535 * (0.5 + metres));
        });
        Terrain ground = new Terrain(
                "ground",
                "map.r16",
                Vec3.ZERO,
                new Terrain.Sides(12, 12),
                new Terrain.HeightRange(-0.5, 0.5),
                List.of(),
                true);
        Level level = new TestLevel()
                .level()
                .with(new PlayerStart(new Vec3(0, 0.05, 3), 45, -40), new PortalGun(1.2, 2.1, PortalShape.ARCH, 500))
                .with(List.of(), List.of(), List.of(bodies))
                .withTerrains(List.of(ground));
        simulation = new Simulation(SimLevel.of(PlacedLevel.of(level, map)), SimSettings.DEFAULT);
        previews = new ShotPreviews(simulation);
        state = simulation.start();
        for (int i = 0; i < 240; i++) {
            step(PlayerInput.NONE);
        }
    }

    private void step(PlayerInput input) {
        state = simulation.step(state, input);
        previews.after(state);
    }

    private static CrosshairState.Half refused(long millimetres) {
        return new CrosshairState.Half(false, Shot.REFUSED, millimetres);
    }

    private void assertShown(Colour shot, CrosshairState.Half expected) {
        assertEquals(expected, previews.half(state, shot), shot.toString());
    }

    /** The outline is where the shot will open the portal, on ground as on a wall. */
    @Test
    void theOutlineOnUnevenGroundIsThePortalThatFollows() {
        FrameState.PortalPreview shown = previews.previews(state).get(0);
        assertEquals(1, previews.previews(state).size());
        step(PlayerInput.NONE.holding(Action.FIRE_FIRST));
        assertEquals(shown.portal(), state.world().portals().portal(0));
        assertEquals(List.of(), previews.previews(state), "the other shot is barred by the portal");
    }

    @Test
    void aRefusalSaysByHowMuchTheGroundIsUneven() {
        step(RIGHT);
        assertEquals(List.of(), previews.previews(state));
        assertShown(Colour.FIRST, refused(30));
        assertShown(Colour.SECOND, refused(30));
    }

    @Test
    void theyAreKeptUntilTheAimMoves() {
        List<FrameState.PortalPreview> shown = previews.previews(state);
        step(PlayerInput.NONE);
        assertSame(shown, previews.previews(state));
        step(PlayerInput.NONE.turning(1, 0));
        assertNotSame(shown, previews.previews(state));
    }

    /** A body that moves may come in the way. */
    @Test
    void theyAreNotKeptWhileABodyMoves() {
        start(new Body.Sphere("ball", new Vec3(4, 60, 4), 0.3, 1, null, 0.6, 0));
        List<FrameState.PortalPreview> shown = previews.previews(state);
        step(PlayerInput.NONE);
        assertNotSame(shown, previews.previews(state));
    }

    /** While the aim moves over uneven ground, the search is made again only after a thirtieth of a second. */
    @Test
    void aSearchOfUnevenGroundIsKeptForAWhile() {
        step(RIGHT);
        assertShown(Colour.FIRST, refused(30));
        for (int tick = 1; tick < 120 / ShotPreviews.SEARCHES_PER_SECOND; tick++) {
            step(tick == 1 ? PlayerInput.NONE.turning(90_000, 0) : PlayerInput.NONE);
            assertShown(Colour.FIRST, refused(30));
        }
        step(PlayerInput.NONE);
        assertShown(Colour.FIRST, new CrosshairState.Half(false, Shot.OPENS, 0));
    }

    /** Beside a shot's portal on the even part, which it may move but the other shot may not cover, both are asked. */
    @ParameterizedTest
    @EnumSource
    void besideAShotsPortalEachShotHasItsOwnAnswer(Colour fired) {
        step(PlayerInput.NONE.holding(fired == Colour.FIRST ? Action.FIRE_FIRST : Action.FIRE_SECOND));
        for (int turn = 0; turn < 30; turn++) {
            step(PlayerInput.NONE.turning(-3000, 0));
            for (int tick = 0; tick < 4; tick++) {
                step(PlayerInput.NONE);
            }
            for (Colour shot : Colour.BOTH) {
                boolean opens = simulation.aim(state, shot) instanceof PlacementResult.Fits;
                assertEquals(
                        opens ? Shot.OPENS : Shot.REFUSED,
                        previews.half(state, shot).shot(),
                        turn + " " + shot);
            }
        }
    }
}
