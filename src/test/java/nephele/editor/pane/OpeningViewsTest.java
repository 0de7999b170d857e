package nephele.editor.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

class OpeningViewsTest {
    private static final PaneLayout PANES = PaneLayout.initial();

    /** The level is 2 km above the origin. */
    @Test
    void aLevelIsSeenFromItsFirstCamera() {
        Level level = LevelFile.load(Path.of("levels/05-above-the-clouds.json")).level();
        PaneLayout shown = OpeningViews.of(level, PANES);
        Vec3 eye = level.cameras().get(0).position();
        Vec3 target = level.cameras().get(0).target();
        assertEquals(eye, shown.eye().eye());
        Vec3 along = target.minus(eye);
        double yaw = Math.toRadians(shown.eye().yawDegrees());
        double pitch = Math.toRadians(shown.eye().pitchDegrees());
        assertEquals(along.x() / along.length(), -Math.sin(yaw) * Math.cos(pitch), 1e-9);
        assertEquals(along.y() / along.length(), Math.sin(pitch), 1e-9);
        assertEquals(along.z() / along.length(), -Math.cos(yaw) * Math.cos(pitch), 1e-9);
        for (PaneView view : shown.views()) {
            assertEquals(target, view.plan().centre());
        }
    }

    @Test
    void withoutCamerasItIsSeenFromItsStartAndWithoutStartAsBefore() {
        Level bare = new TestLevel().level();
        assertSame(PANES, OpeningViews.of(bare, PANES));
        String text =
                "{\"format\": \"nephele-level\", \"version\": 1, \"name\": \"start\", \"player\": {\"feet\": [5, 30,"
                        + " 7], \"yawDegrees\": 90}}";
        Level start = LevelJson.read("start.json", text.getBytes(StandardCharsets.UTF_8));
        PerspectiveCamera shown = OpeningViews.of(start, PANES).eye();
        assertEquals(new Vec3(5, 31.65, 7), shown.eye());
        assertEquals(90, shown.yawDegrees());
    }
}
