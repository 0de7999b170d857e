package nephele.editor.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneLayout.Arrangement;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PaneLayout.Splitter;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class PaneLayoutTest {
    private static final PaneSize SIZE = new PaneSize(804, 604);
    private static final int GAP = 4;

    private final PaneLayout layout = PaneLayout.initial();

    @Test
    void fourPanesFillTheViewportExceptTheGaps() {
        List<PaneRectangle> panes = layout.rectangles(SIZE, GAP);
        assertEquals(
                List.of(
                        new PaneRectangle(0, 0, 0, 400, 300),
                        new PaneRectangle(1, 404, 0, 400, 300),
                        new PaneRectangle(2, 0, 304, 400, 300),
                        new PaneRectangle(3, 404, 304, 400, 300)),
                panes);
    }

    @Test
    void everyPixelIsInOnePaneOrOnASplitter() {
        PaneLayout uneven = layout.split(Splitter.BOTH, 210.4, 433, SIZE);
        for (int x = 0; x < SIZE.width(); x += 3) {
            for (int y = 0; y < SIZE.height(); y += 3) {
                boolean isPane = uneven.paneAt(x, y, SIZE, GAP).isPresent();
                assertNotEquals(isPane, uneven.splitterAt(x, y, SIZE, GAP).isPresent(), x + ", " + y);
            }
        }
    }

    @Test
    void aSplitterFollowsThePointerButLeavesBothSidesVisible() {
        assertEquals(Optional.of(Splitter.COLUMNS), layout.splitterAt(402, 10, SIZE, GAP));
        assertEquals(Optional.of(Splitter.ROWS), layout.splitterAt(10, 302, SIZE, GAP));
        assertEquals(Optional.of(Splitter.BOTH), layout.splitterAt(402, 302, SIZE, GAP));
        PaneLayout moved = layout.split(Splitter.COLUMNS, 200, 10, SIZE);
        assertEquals(200, moved.rectangles(SIZE, GAP).get(0).width(), 2);
        assertEquals(300, moved.rectangles(SIZE, GAP).get(0).height());
        PaneLayout far = layout.split(Splitter.BOTH, -50, 1e6, SIZE);
        assertEquals(0.1, far.columnFraction(), 1e-12);
        assertEquals(0.9, far.rowFraction(), 1e-12);
    }

    @Test
    void theActivePaneIsMaximisedAndRestored() {
        PaneLayout maximised = layout.withActive(2).maximiseToggled();
        assertEquals(List.of(new PaneRectangle(2, 0, 0, 804, 604)), maximised.rectangles(SIZE, GAP));
        assertEquals(layout.withActive(2), maximised.maximiseToggled());
        assertTrue(maximised.splitterAt(402, 302, SIZE, GAP).isEmpty());
    }

    @Test
    void anActivePaneBeyondTheArrangementBecomesTheLastOne() {
        assertEquals(0, layout.withActive(3).with(Arrangement.ONE).active());
        assertEquals(1, layout.withActive(3).with(Arrangement.TWO).active());
    }

    @Test
    void fourCyclesOfAKindAreNone() {
        PaneLayout one = layout.withActive(1).cycled();
        assertEquals(PaneKind.FRONT, one.activeView().camera() instanceof PlanCamera plan ? plan.kind() : null);
        assertEquals(layout.withActive(1), one.cycled().cycled().cycled());
    }

    @Test
    void linkedPlansFollowTheActiveOneAndPerspectivesStay() {
        PlanCamera moved = new PlanCamera(PaneKind.FRONT, new Vec3(1, 2, 3), 0.5);
        PaneLayout linked =
                layout.withActive(2).with(2, layout.views().get(2).with(moved)).plansLinked();
        assertEquals(
                new PlanCamera(PaneKind.SIDE, new Vec3(1, 2, 3), 0.5),
                linked.views().get(3).camera());
        assertEquals(layout.views().get(0).camera(), linked.views().get(0).camera());
        assertEquals(layout, layout.plansLinked());
    }

    @Test
    void aViewportWithoutPixelsStillHasPanes() {
        layout.rectangles(new PaneSize(0, 0), GAP)
                .forEach(pane -> assertTrue(pane.width() > 0 && pane.height() > 0, pane.toString()));
    }

    @Test
    void theEyeIsThatOfThePerspectivePaneWhicheverIsActive() {
        var camera = new PerspectiveCamera(new Vec3(1, 2, 3), 30, -10, 70);
        PaneLayout moved =
                PaneLayout.initial().with(0, PaneLayout.initial().views().get(0).with(camera));
        assertEquals(camera, moved.eye());
        assertEquals(camera, moved.withActive(2).eye());
        assertEquals(camera, moved.withActive(1).maximiseToggled().eye());
    }

    /** The level is 2 km above the origin. */
    @Test
    void aLevelIsSeenFromItsFirstCamera() {
        Level level = LevelFile.load(Path.of("levels/05-above-the-clouds.json")).level();
        PaneLayout opened = layout.opened(level);
        Vec3 eye = level.cameras().get(0).position();
        Vec3 target = level.cameras().get(0).target();
        assertEquals(eye, opened.eye().eye());
        Vec3 along = target.minus(eye);
        double yaw = Math.toRadians(opened.eye().yawDegrees());
        double pitch = Math.toRadians(opened.eye().pitchDegrees());
        assertEquals(along.x() / along.length(), -Math.sin(yaw) * Math.cos(pitch), 1e-9);
        assertEquals(along.y() / along.length(), Math.sin(pitch), 1e-9);
        assertEquals(along.z() / along.length(), -Math.cos(yaw) * Math.cos(pitch), 1e-9);
        for (PaneView view : opened.views()) {
            assertEquals(target, view.plan().centre());
        }
    }

    @Test
    void withoutCamerasItIsSeenFromItsStartAndWithoutStartAsBefore() {
        Level bare = new TestLevel().level();
        assertSame(layout, layout.opened(bare));
        String text =
                "{\"format\": \"nephele-level\", \"version\": 1, \"name\": \"start\", \"player\": {\"feet\": [5, 30,"
                        + " 7], \"yawDegrees\": 90}}";
        Level start = LevelJson.read("start.json", text.getBytes(StandardCharsets.UTF_8));
        PerspectiveCamera opened = layout.opened(start).eye();
        assertEquals(new Vec3(5, 31.65, 7), opened.eye());
        assertEquals(90, opened.yawDegrees());
    }
}
