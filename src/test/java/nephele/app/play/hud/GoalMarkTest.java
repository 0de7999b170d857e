package nephele.app.play.hud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.render.pass.overlay.DrawnBounds;
import nephele.engine.render.pass.overlay.FontAtlas;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import org.junit.jupiter.api.Test;

/** The mark of the goal is at the goal, or an arrow at the edge beyond which it is, inside every window. */
class GoalMarkTest {
    private static final Area AREA = new Area(1280, 720);

    @Test
    void bracketsAreAroundAGoalInThePicture() {
        GoalMark mark = GoalMark.at(AREA, true, 100, 20, 30, 23);
        assertEquals(new GoalMark(100, 20, "", 30, 23), mark);
        assertEquals(12, GoalMark.at(AREA, true, 100, 20, 0.1, 900).half(), "far goals are still marked");
    }

    @Test
    void arrowsPointAtAGoalBeyondTheEdgeOrBehind() {
        assertEquals("→", GoalMark.at(AREA, true, 900, 0, 30, 5).arrow());
        assertEquals("↑", GoalMark.at(AREA, true, 10, -400, 30, 5).arrow());
        assertEquals("↓", GoalMark.at(AREA, true, 10, 400, 30, 5).arrow());
        assertEquals("←", GoalMark.at(AREA, false, -3, 0, 30, 5).arrow());
        assertEquals("→", GoalMark.at(AREA, false, 0, 90, 30, 5).arrow());
    }

    @Test
    void everyMarkIsInsideThePicture() {
        var canvas = new OverlayCanvas(new FontAtlas());
        for (Area area : new Area[] {new Area(640, 360), AREA, new Area(2560, 1080)}) {
            for (int i = 0; i < 64; i++) {
                double right = (i % 8 - 3.5) * area.width() / 3;
                double down = (i / 8 - 3.5) * area.height() / 3;
                canvas.begin(1);
                GoalMark.at(area, i % 3 > 0, right, down, 40, 12345).draw(canvas, area);
                DrawnBounds drawn = DrawnBounds.of(canvas);
                String what = right + " " + down + " " + drawn;
                assertTrue(drawn.left() >= -6 && drawn.right() <= area.width() + 6, what);
                assertTrue(drawn.top() >= -6 && drawn.bottom() <= area.height() + 6, what);
            }
        }
    }
}
