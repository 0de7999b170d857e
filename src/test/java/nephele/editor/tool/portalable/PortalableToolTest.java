package nephele.editor.tool.portalable;

import static nephele.editor.tool.ToolTrial.FLOOR;
import static nephele.editor.tool.ToolTrial.WALL;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.editor.pane.MarkColour;
import nephele.editor.tool.ToolTrial;
import nephele.engine.level.BoxFace;
import nephele.engine.level.EditorNotes;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The portalable tool changes single faces. */
@Execution(ExecutionMode.CONCURRENT)
class PortalableToolTest {
    private static ToolTrial hall() {
        return new ToolTrial(RoomLevel.hall().level(), PortalableTool::new);
    }

    private static Solid.Box box(ToolTrial trial, int index) {
        return (Solid.Box) trial.level().solids().get(index);
    }

    @Test
    void aClickTogglesAFaceThere() {
        ToolTrial trial = hall();
        Level before = trial.level();
        trial.click(FLOOR);
        assertEquals(false, box(trial, 0).faces().get(BoxFace.PLUS_Y).portalable());
        assertEquals(1, box(trial, 0).faces().size());
        trial.assertOneSoundStep(before);
        trial.click(FLOOR);
        assertEquals(before, trial.level(), "back to what the solid says, without a word about the face");
    }

    @Test
    void aDragMakesAllFacesLikeTheFirst() {
        ToolTrial trial = hall();
        trial.click(WALL);
        Level before = trial.level();
        trial.drag(FLOOR, WALL);
        assertFalse(box(trial, 0).faces().get(BoxFace.PLUS_Y).portalable());
        assertSame(before.solids().get(4), trial.level().solids().get(4));
        trial.assertOneSoundStep(before);
        trial.drag(WALL, FLOOR);
        assertTrue(box(trial, 0).faces().isEmpty());
        assertTrue(box(trial, 4).faces().isEmpty());
    }

    @Test
    void aFastDragTouchesTheFacesBetween() {
        ToolTrial trial = hall();
        trial.drag(FLOOR, new Vec3(0, 6, -4));
        assertFalse(box(trial, 4).faces().get(BoxFace.PLUS_Z).portalable());
        assertFalse(box(trial, 1).faces().get(BoxFace.MINUS_Y).portalable());
    }

    @Test
    void theHoveredSolidShowsItsFaces() {
        ToolTrial trial = hall();
        trial.click(FLOOR);
        trial.tool().moved(trial.over(FLOOR));
        List<MarkColour> colours =
                trial.tool().marks().stream().map(mark -> mark.colour()).toList();
        assertEquals(6, colours.size());
        assertEquals(
                1,
                colours.stream().filter(colour -> colour == MarkColour.REFUSED).count());
    }

    @Test
    void escapeGivesTheLevelBack() {
        hall().assertCancelledDrag(FLOOR, WALL);
    }

    @Test
    void aLockedSolidStays() {
        Level hall = RoomLevel.hall().level();
        Level locked = hall.with(new EditorNotes(List.of(), List.of(), List.of("solids/box0"), List.of()));
        ToolTrial trial = new ToolTrial(locked, PortalableTool::new);
        Level before = trial.level();
        trial.click(FLOOR);
        assertSame(before, trial.level());
    }
}
