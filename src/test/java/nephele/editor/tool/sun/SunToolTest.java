package nephele.editor.tool.sun;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import nephele.editor.pane.PaneKind;
import nephele.editor.save.DraftLevel;
import nephele.editor.tool.ToolTrial;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.level.Sun;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The sun tool puts the sun where the pointer is. */
@Execution(ExecutionMode.CONCURRENT)
class SunToolTest {
    private static final Vec3 EYE = new Vec3(0, 2, 6);

    private static void assertTowards(Vec3 direction, Sun sun) {
        Vec3 towards = sun.directionTowardsSun();
        assertEquals(0, towards.cross(direction.scaled(1 / direction.length())).length(), 2e-4, towards.toString());
    }

    @Test
    void aDragPutsANewSunLiveAndInOneStep() {
        ToolTrial trial = new ToolTrial(RoomLevel.hall().level(), SunTool::new).lookingFrom(EYE, 0, 30);
        Level before = trial.level();
        trial.press(EYE.plus(new Vec3(0, 1, -1)));
        assertTowards(new Vec3(0, 1, -1), trial.level().environment().sun());
        assertFalse(trial.tool().marks().isEmpty());
        Vec3 there = new Vec3(0.5, 0.7, -1);
        trial.tool().dragged(trial.over(EYE.plus(there)));
        assertTowards(there, trial.level().environment().sun());
        trial.tool().released(trial.over(EYE.plus(there)));
        assertNotNull(trial.level().environment().sun());
        trial.assertOneSoundStep(before);
    }

    @Test
    void theSunKeepsItsLight() {
        Level level = DraftLevel.of(
                "\"player\": {\"feet\": [0, 0, 0]}, \"environment\": {\"sun\": {\"directionTowardsSun\": [0, 1, 0],"
                        + " \"irradiance\": [7, 6, 5], \"castsShadow\": false}}");
        ToolTrial trial = new ToolTrial(level, SunTool::new).lookingFrom(EYE, 0, 30);
        Level before = trial.level();
        trial.click(EYE.plus(new Vec3(0, 1, -1)));
        Sun sun = trial.level().environment().sun();
        assertEquals(new Vec3(7, 6, 5), sun.irradiance());
        assertFalse(sun.castsShadow());
        trial.assertOneSoundStep(before);
    }

    @Test
    void escapeAndPlansLeaveItAlone() {
        ToolTrial trial = new ToolTrial(RoomLevel.hall().level(), SunTool::new).lookingFrom(EYE, 0, 30);
        Level before = trial.level();
        trial.press(EYE.plus(new Vec3(0, 1, -1)));
        trial.assertCancelled(before);
        trial.inPlan(PaneKind.TOP).drag(new Vec3(1, 0, 1), new Vec3(2, 0, 2));
        assertSame(before, trial.level());
        assertNull(trial.level().environment().sun());
        assertEquals(List.of(SunTool.ENTRY.description().english()), trial.messages());
    }
}
