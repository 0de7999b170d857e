package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.GunInHand;
import nephele.engine.scene.dynamic.CharacterPresence;
import org.junit.jupiter.api.Test;

/** The gun in the hand: required only by a player with a gun, and never cut by a wall or an opening. */
class GunGlTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 54;
    private static final GunInHand GUN = new GunInHand(new Vec3(0.2, -0.172, -0.5), 0.05, 0.035, 0, 0, 0, 0);

    private static List<String> required(Level level, CharacterPresence character) {
        PlacedLevel placed = PlacedLevel.of(level, NoFiles.AT_ALL);
        FrameRequest request = FrameRequest.of(level, placed.statics(), null, Output.PLAIN, Quality.HIGH, character);
        return FramePlan.of(request).steps().stream()
                .filter(step -> !step.required().isEmpty())
                .map(step -> step.feature().name())
                .filter(name -> name.startsWith("gun") || name.equals("shot"))
                .toList();
    }

    @Test
    void onlyAPlayerWithAGunRequiresIt() {
        Level with = RoomLevel.hall().gun().level();
        assertEquals(List.of("gun", "shot", "gun.opening"), required(with, CharacterPresence.POSSIBLE));
        assertEquals(List.of(), required(with, CharacterPresence.NEVER), "a picture without its player");
        assertEquals(List.of(), required(RoomLevel.hall().level(), CharacterPresence.POSSIBLE), "no gun");
    }

    /** The unlit room is black: what the gun changes has the colours of its lamps. */
    @Test
    void neitherWallsNorOpeningsCutIt() {
        Level hall = RoomLevel.hall().gun().level();
        Level portals = RoomLevel.hall()
                .gun()
                .pair(new Vec3(0, 1.05, -8), new Vec3(0, 0, 1), new Vec3(-8, 1.05, 0), new Vec3(1, 0, 0))
                .level();
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            int[] free = draw(offscreen, hall, 0);
            int[] atWall = draw(offscreen, hall, -7.93);
            int[] inOpening = draw(offscreen, portals, -7.97);
            int seen = 0;
            for (int i = 0; i < free.length; i++) {
                if (free[i] != 0) {
                    seen++;
                    assertEquals(free[i], atWall[i], "at a wall, pixel " + i);
                    assertEquals(free[i], inOpening[i], "in an opening, pixel " + i);
                }
            }
            assertTrue(seen > 100, seen + " pixels");
        }
    }

    private static int[] draw(Offscreen offscreen, Level level, double z) {
        RenderSettings settings = RenderSettings.of(Output.PLAIN, Quality.HIGH).with(CharacterPresence.POSSIBLE);
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            FrameState frameState = FrameState.atStart(level);
            frameState.gun(GUN);
            Vec3 eye = new Vec3(0, 1.5, z);
            renderer.draw(offscreen.view(eye, eye.plus(new Vec3(0, 0, -1))), frameState, offscreen.picture);
            offscreen.gl.requireNoError("gun");
            return offscreen.pixels();
        }
    }
}
