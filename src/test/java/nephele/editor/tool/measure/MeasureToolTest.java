package nephele.editor.tool.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import nephele.editor.pane.Mark;
import nephele.editor.tool.ToolTrial;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The measure tool snaps to vertices and the grid and changes nothing. */
@Execution(ExecutionMode.CONCURRENT)
class MeasureToolTest {
    private static ToolTrial hall() {
        return new ToolTrial(RoomLevel.hall().box(1.1, 0, -3.3, 2.3, 1.7, -2.2).level(), MeasureTool::new);
    }

    private static Mark.Line line(ToolTrial trial) {
        return (Mark.Line) trial.tool().marks().get(0);
    }

    @Test
    void aDragBetweenVerticesMeasuresExactly() {
        ToolTrial trial = hall();
        Level before = trial.level();
        trial.drag(new Vec3(1.12, 0.01, -2.2), new Vec3(2.29, 1.69, -2.2));
        assertEquals(new Vec3(1.1, 0, -2.2), line(trial).from());
        assertEquals(new Vec3(2.3, 1.7, -2.2), line(trial).to());
        Mark.Label label = (Mark.Label) trial.tool().marks().get(3);
        assertEquals("2.081 m  dx 1.200  dy 1.700  dz 0.000", label.text());
        assertEquals(label.text(), trial.tool().hint().english());
        assertSame(before, trial.level());
    }

    @Test
    void awayFromVerticesItSnapsToTheGridOnTheSurface() {
        ToolTrial trial = hall();
        trial.drag(new Vec3(-3.1, 0, -2.1), new Vec3(-3.1, 2.9, -8));
        assertEquals(new Vec3(-3, 0, -2), line(trial).from());
        assertEquals(new Vec3(-3, 3, -8), line(trial).to());
    }

    @Test
    void escapeAndAClickForgetTheMeasure() {
        ToolTrial trial = hall();
        trial.drag(new Vec3(-3, 0, -2), new Vec3(3, 0, -5));
        trial.tool().cancel();
        assertEquals(List.of(), trial.tool().marks());
        trial.drag(new Vec3(-3, 0, -2), new Vec3(3, 0, -5));
        trial.click(new Vec3(-3, 0, -2));
        assertEquals(1, trial.tool().marks().size());
    }
}
