package nephele.editor.tool.portal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.editor.document.Selection;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.record.EntityRef;
import nephele.editor.tool.ToolTrial;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Level;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.RoomLevel;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The portal tool opens pairs where the gun would. */
@Execution(ExecutionMode.CONCURRENT)
class PortalToolTest {
    private static final Vec3 AHEAD = new Vec3(-2, 3, -8);
    private static final Vec3 RIGHT = new Vec3(8, 3, -3);

    private static ToolTrial hall() {
        return new ToolTrial(
                RoomLevel.hall().gun().box(3, 0, -8, 4, 6, -7, false).level(), PortalTool::new);
    }

    private static MarkColour colour(ToolTrial trial) {
        List<Mark> marks = trial.tool().marks();
        return marks.get(marks.size() - 1).colour();
    }

    @Test
    void twoClicksAreAPairInOneStep() {
        ToolTrial trial = hall();
        Level before = trial.level();
        trial.click(AHEAD);
        assertSame(before, trial.level());
        assertTrue(trial.tool().marks().stream().anyMatch(mark -> mark.colour() == MarkColour.PREVIEW));
        trial.click(RIGHT);
        PortalSpec one = trial.level().portals().get(0);
        PortalSpec two = trial.level().portals().get(1);
        assertEquals(two.id(), one.linkedTo());
        assertEquals(one.id(), two.linkedTo());
        assertTrue(one.centre().minus(AHEAD).length() < 1e-6, one.toString());
        assertEquals(new Vec3(-1, 0, 0), two.normal());
        assertEquals(2, trial.document().selection().entities().size());
        trial.assertOneSoundStep(before);
        assertEquals(2, trial.level().portals().size());
    }

    /** On a slope of 20°, where a portal's up direction depends on the view of the click. */
    @Test
    void twoClicksOnARampAreAPair() {
        Level hall = RoomLevel.hall().gun().level();
        List<Solid> solids = new ArrayList<>(hall.solids());
        double rise = 8 * Math.tan(Math.toRadians(20));
        Vec3 middle = new Vec3(0, rise / 2, -4);
        solids.add(new Solid.Wedge("ramp", null, true, null, middle, new Vec3(8, rise, 8), BoxFace.MINUS_Z, Map.of()));
        ToolTrial trial = new ToolTrial(hall.with(hall.materials(), solids), PortalTool::new);
        trial.lookingFrom(new Vec3(-3, 4, 3), -30, -25);
        trial.click(middle.plus(new Vec3(-1, 0, 0)));
        trial.click(middle.plus(new Vec3(1, 0, 0)));
        assertEquals(List.of(), trial.messages());
        assertEquals(2, trial.level().portals().size());
        assertEquals(
                Math.cos(Math.toRadians(20)),
                trial.level().portals().get(1).normal().y(),
                1e-6);
    }

    @Test
    void theGhostSaysWhatTheGunWouldDo() {
        ToolTrial trial = hall();
        trial.tool().moved(trial.over(AHEAD));
        assertEquals(MarkColour.ALLOWED, colour(trial));
        assertEquals("A portal fits here", trial.tool().hint().english());
        trial.tool().moved(trial.over(new Vec3(-2, 0.75, -8)));
        assertEquals(MarkColour.SLIDES, colour(trial));
        assertEquals("A portal slides 0.30 m to fit", trial.tool().hint().english());
        trial.tool().moved(trial.over(new Vec3(3.5, 3, -7)));
        assertEquals(MarkColour.REFUSED, colour(trial));
        trial.click(new Vec3(3.5, 3, -7));
        assertEquals(List.of("No portal: this surface takes none"), trial.messages());
    }

    /** As in the game, a click near above the floor gives a portal on it, unless the level forbids it. */
    @Test
    void aClickAtEyeHeightIsAPortalOnTheFloor() {
        for (boolean toFloor : new boolean[] {true, false}) {
            Level hall = RoomLevel.hall().gun().level();
            PortalGun gun = new PortalGun(1.2, 2.1, PortalShape.ARCH, 500, toFloor);
            ToolTrial trial = new ToolTrial(hall.with(hall.player(), gun), PortalTool::new);
            trial.click(new Vec3(-2, 1.65, -8));
            trial.click(new Vec3(0, 1.65, -8));
            assertEquals(
                    toFloor ? 1.05 : 1.65,
                    trial.level().portals().get(1).centre().y(),
                    1e-6);
        }
    }

    @Test
    void theFirstPortalIsInTheWayOfTheSecond() {
        ToolTrial trial = hall();
        trial.click(AHEAD);
        assertOccupied(trial, AHEAD);
    }

    private static void assertOccupied(ToolTrial trial, Vec3 place) {
        Level before = trial.level();
        trial.click(place);
        assertEquals(List.of("No portal: another portal is in its place"), trial.messages());
        assertSame(before, trial.level());
    }

    @Test
    void portalsOfTheLevelAreInTheWay() {
        ToolTrial trial = hall();
        trial.click(AHEAD);
        trial.click(RIGHT);
        trial.document().select(Selection.NONE);
        assertOccupied(trial, RIGHT);
    }

    @Test
    void escapeForgetsTheFirst() {
        ToolTrial trial = hall();
        Level before = trial.level();
        trial.click(AHEAD);
        trial.assertCancelled(before);
        assertEquals(List.of(), trial.tool().marks());
        trial.click(RIGHT);
        assertSame(before, trial.level(), "this click is a first one again");
    }

    @Test
    void aSelectedPortalMovesAlongTheWallsAndKeepsItsPartner() {
        ToolTrial trial = hall();
        trial.click(AHEAD);
        trial.click(RIGHT);
        Level before = trial.level();
        String id = before.portals().get(0).id();
        trial.document().select(Selection.of(new EntityRef("portals", id)));
        Vec3 there = new Vec3(0, 3.5, -8);
        trial.press(AHEAD);
        trial.tool().dragged(trial.over(new Vec3(3.5, 3, -7)));
        trial.tool().dragged(trial.over(there));
        trial.tool().released(trial.over(there));
        PortalSpec moved = trial.level().portals().get(0);
        assertTrue(moved.centre().minus(there).length() < 1e-6, moved.toString());
        assertEquals(before.portals().get(0).linkedTo(), moved.linkedTo());
        assertSame(before.portals().get(1), trial.level().portals().get(1));
        trial.assertOneSoundStep(before);
    }

    @Test
    void escapeDuringAMoveGivesTheLevelBack() {
        ToolTrial trial = hall();
        trial.click(AHEAD);
        trial.click(RIGHT);
        Level before = trial.level();
        trial.press(AHEAD);
        trial.tool().dragged(trial.over(new Vec3(0, 3.5, -8)));
        trial.tool().cancel();
        assertSame(before, trial.level());
    }

    @Test
    void aFirstPortalWhoseWallIsGoneIsPlacedAgain() {
        ToolTrial trial = hall();
        trial.click(AHEAD);
        Level without = trial.level().with(List.of(), trial.level().solids().subList(0, 4));
        trial.document().reset(without);
        trial.click(RIGHT);
        assertEquals(List.of("The first portal no longer fits: place it again"), trial.messages());
        assertSame(without, trial.level());
    }
}
