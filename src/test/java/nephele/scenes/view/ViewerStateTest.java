package nephele.scenes.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import nephele.engine.math.SeededNoise;
import nephele.engine.math.Vec3;
import nephele.scenes.fixed.LightTerm;
import nephele.scenes.fixed.SceneAppearance;
import nephele.scenes.fixed.Shading;
import nephele.scenes.xml.XmlScene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The same keys give the same place at every frame rate, and each key does what its hint says. */
class ViewerStateTest {
    private static final XmlScene.Eye EYE =
            new XmlScene.Eye(Vec3.ZERO, new Vec3(0, 0, 1), new Vec3(0, 1, 0), 45, 1, 1000);

    /** Keys held for a time (seconds), after presses. */
    private record Leg(List<ViewerKey> presses, double seconds, Set<ViewerKey> held) {}

    private static final List<Leg> FLIGHT = List.of(
            new Leg(List.of(), 0.1, Set.of(ViewerKey.AHEAD)),
            new Leg(List.of(), 1.25, Set.of(ViewerKey.AHEAD, ViewerKey.RIGHT)),
            new Leg(List.of(ViewerKey.TURN_LEFT, ViewerKey.LOOK_DOWN), 0.2, Set.of()),
            new Leg(List.of(), 0.75, Set.of(ViewerKey.LEFT, ViewerKey.FASTER)),
            new Leg(List.of(), 0.6, Set.of()),
            new Leg(List.of(ViewerKey.LOOK_UP, ViewerKey.LOOK_UP), 2, Set.of(ViewerKey.BACK)),
            new Leg(List.of(), 0.45, Set.of(ViewerKey.AHEAD, ViewerKey.BACK)));

    private static ViewerState towing() {
        return ViewerState.towing(EYE, SceneAppearance.USUAL, 0);
    }

    private static ViewerState flown(int framesPerSecond) {
        var viewing = towing();
        for (Leg leg : FLIGHT) {
            leg.presses.forEach(key -> viewing.press(key));
            double left = leg.seconds;
            for (; left > 1.0 / framesPerSecond; left -= 1.0 / framesPerSecond) {
                viewing.advance(1.0 / framesPerSecond, leg.held);
            }
            viewing.advance(left, leg.held);
        }
        return viewing;
    }

    private static void assertSamePlace(ViewerState expected, ViewerState actual) {
        assertTrue(
                expected.place().eye().toVector().distance(actual.place().eye().toVector()) < 1e-12, "eye");
        assertTrue(expected.place().worldFromEntity().equals(actual.place().worldFromEntity(), 1e-12), "entity");
        assertEquals(expected.sceneSeconds(), actual.sceneSeconds(), 1e-12);
    }

    @ParameterizedTest
    @ValueSource(ints = {7, 30, 60, 144, 240, 1000})
    void aFlightEndsAtOnePlaceAtEveryFrameRate(int framesPerSecond) {
        assertSamePlace(flown(1), flown(framesPerSecond));
    }

    @Test
    void aFlightEndsAtOnePlaceWhereFramesAreUneven() {
        var noise = new SeededNoise(67);
        var uneven = towing();
        int frame = 0;
        for (Leg leg : FLIGHT) {
            leg.presses.forEach(key -> uneven.press(key));
            double left = leg.seconds;
            for (; left > 0.1; frame++) {
                double part = 0.09 * noise.unit(frame, 0, 0);
                uneven.advance(part, leg.held);
                left -= part;
            }
            uneven.advance(left, leg.held);
        }
        assertSamePlace(flown(1), uneven);
    }

    /**
     * A replay ends bit for bit at the same place on every machine: nothing reads a clock, and angles use StrictMath.
     */
    @Test
    void aReplayEndsWhereItAlwaysHas() {
        var place = flown(60).place();
        assertEquals(new Vec3(11.723673932145626, -1.0339842227467535, -6.680777241374947), place.eye());
        assertEquals(-2.3117483737933404E-4, place.bankDegrees());
    }

    @Test
    void aPressTurnsFiveDegreesAndAPixelHalfADegree() {
        var viewing = towing();
        viewing.press(ViewerKey.TURN_LEFT);
        viewing.press(ViewerKey.LOOK_DOWN);
        assertEquals(5, viewing.place().heading().yawDegrees());
        assertEquals(-5, viewing.place().heading().pitchDegrees());
        viewing.drag(20, -10);
        assertEquals(-5, viewing.place().heading().yawDegrees(), "to the right");
        assertEquals(0, viewing.place().heading().pitchDegrees(), "and up");
        viewing.press(ViewerKey.TURN_RIGHT);
        viewing.press(ViewerKey.LOOK_UP);
        viewing.press(ViewerKey.HOME);
        assertEquals(0, viewing.place().heading().yawDegrees());
    }

    @Test
    void oppositeKeysCancelAndWithoutAnEntityTheCameraFollowsAtOnce() {
        var viewing = ViewerState.alone(EYE, SceneAppearance.USUAL, 0);
        viewing.advance(1, Set.of(ViewerKey.LEFT, ViewerKey.RIGHT, ViewerKey.FASTER));
        assertEquals(Vec3.ZERO, viewing.place().eye());
        viewing.advance(0.5, Set.of(ViewerKey.AHEAD));
        assertEquals(3, viewing.place().eye().z(), 1e-12);
    }

    @Test
    void thePauseStopsTheScenesClockAndNothingElse() {
        var viewing = ViewerState.towing(EYE, SceneAppearance.USUAL, 5);
        viewing.advance(1, Set.of());
        viewing.press(ViewerKey.PAUSE);
        viewing.advance(1, Set.of(ViewerKey.AHEAD));
        assertEquals(6, viewing.sceneSeconds());
        assertEquals(5, viewing.place().eye().z(), 1e-12);
        viewing.press(ViewerKey.PAUSE);
        viewing.advance(Double.NaN, Set.of());
        viewing.advance(-1, Set.of());
        viewing.advance(0.5, Set.of());
        assertEquals(6.5, viewing.sceneSeconds());
    }

    @Test
    void keysSwitchHowTheSceneIsShown() {
        var viewing = towing();
        viewing.press(ViewerKey.SHADING);
        assertEquals(Shading.PHONG, viewing.look().shading());
        viewing.press(ViewerKey.WIREFRAME);
        assertEquals(Shading.WIREFRAME, viewing.look().shading());
        viewing.press(ViewerKey.WIREFRAME);
        assertEquals(Shading.PHONG, viewing.look().shading());
        viewing.press(ViewerKey.SHADING);
        assertEquals(Shading.FLAT, viewing.look().shading());
        viewing.press(ViewerKey.AXES);
        assertTrue(viewing.look().axes());
        viewing.press(ViewerKey.DIFFUSE);
        assertEquals(
                Set.of(LightTerm.AMBIENT, LightTerm.SPECULAR, LightTerm.EMISSIVE),
                viewing.look().terms());
        viewing.press(ViewerKey.DIFFUSE);
        assertEquals(Set.of(LightTerm.values()), viewing.look().terms());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.2, 1, 4.0 / 3, 16.0 / 9, 5})
    void aWiderWindowIsAsHigh(double aspect) {
        var projection = towing().view(aspect).projection();
        assertEquals(Math.tan(Math.toRadians(22.5)), projection.tanHalfHeight(), 1e-15);
        assertEquals(aspect * projection.tanHalfHeight(), projection.tanHalfWidth(), 1e-15);
    }
}
