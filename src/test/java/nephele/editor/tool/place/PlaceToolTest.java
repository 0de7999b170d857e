package nephele.editor.tool.place;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import nephele.editor.pane.PaneKind;
import nephele.editor.record.EntityRef;
import nephele.editor.save.DraftLevel;
import nephele.editor.tool.ToolTrial;
import nephele.engine.level.Body;
import nephele.engine.level.Cloud;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.RoomLevel;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The place tool puts entities on surfaces. */
@Execution(ExecutionMode.CONCURRENT)
class PlaceToolTest {
    private static ToolTrial hall() {
        return new ToolTrial(RoomLevel.hall().level(), PlaceTool::new);
    }

    private static ToolTrial hall(String section, String kind) {
        ToolTrial trial = hall();
        trial.options().entity(section, kind);
        return trial;
    }

    @Test
    void aBodyStandsOnTheFloorSnappedToTheGrid() {
        ToolTrial trial = hall();
        Level before = trial.level();
        trial.click(new Vec3(1.4, 0, -2.1));
        Body.Box body = (Body.Box) trial.level().bodies().get(0);
        assertEquals(new Vec3(1.5, 0.3, -2), body.centre());
        assertEquals("box", body.id());
        assertEquals(
                List.of(new EntityRef("bodies", "box")),
                trial.document().selection().entities());
        trial.assertOneSoundStep(before);
        trial.click(new Vec3(-3, 0, -2.1));
        assertEquals("box-2", trial.level().bodies().get(1).id());
    }

    @Test
    void theGhostVanishesWithThePointer() {
        ToolTrial trial = hall();
        trial.tool().moved(trial.over(new Vec3(1.4, 0, -2.1)));
        assertFalse(trial.tool().marks().isEmpty());
        trial.tool().left();
        assertEquals(List.of(), trial.tool().marks());
    }

    @Test
    void lightsKeepOffTheWallAndSpheresTouchIt() {
        ToolTrial trial = hall("lights", "point");
        Level before = trial.level();
        trial.click(new Vec3(1, 3, -8));
        assertEquals(new Vec3(1, 3, -7.7), trial.level().lights().get(0).position());
        assertTrue(trial.level().lights().get(0) instanceof Light.Point);
        trial.assertOneSoundStep(before);
        trial.options().entity("bodies", "sphere");
        trial.click(new Vec3(-1, 3, -8));
        assertEquals(new Vec3(-1, 3, -7.7), trial.level().bodies().get(0).centre());
    }

    @Test
    void thePlayersStartIsReplaced() {
        ToolTrial trial = hall("player", "playerstart");
        Level before = trial.level();
        trial.click(new Vec3(2, 0, -3));
        assertEquals(new Vec3(2, 0, -3), trial.level().player().feet());
        assertEquals(
                List.of(EntityRef.single("player")),
                trial.document().selection().entities());
        trial.assertOneSoundStep(before);
    }

    @Test
    void twoPortalsLeadToEachOtherAndFaceAwayFromTheirWalls() {
        ToolTrial trial = hall("portals", "portalspec");
        trial.click(new Vec3(-3, 2, -8));
        Level one = trial.level();
        trial.click(new Vec3(2, 0, -3));
        PortalSpec wall = trial.level().portals().get(0);
        PortalSpec floor = trial.level().portals().get(1);
        assertEquals(new Vec3(0, 0, 1), wall.normal());
        assertEquals(new Vec3(0, 1, 0), floor.normal());
        assertEquals(floor.id(), wall.linkedTo());
        assertEquals(wall.id(), floor.linkedTo());
        trial.assertOneSoundStep(one);
    }

    @Test
    void draggingMovesTheEntityBeforeItIsPlaced() {
        ToolTrial trial = hall("solids", "box");
        Level before = trial.level();
        trial.press(new Vec3(0, 0, 0));
        assertEquals(7, trial.level().solids().size());
        // A second move over the ghost itself still means the floor behind it.
        trial.tool().dragged(trial.over(new Vec3(0, 0, -0.6)));
        trial.tool().dragged(trial.over(new Vec3(3, 0, -2)));
        assertFalse(trial.tool().marks().isEmpty());
        trial.tool().released(trial.over(new Vec3(3, 0, -2)));
        assertEquals(new Vec3(3, 0.5, -2), ((Solid.Box) trial.level().solids().get(6)).centre());
        trial.assertOneSoundStep(before);
    }

    @Test
    void everySolidHasAVolume() {
        for (String kind : List.of("box", "planes", "wedge", "prism")) {
            ToolTrial trial = hall("solids", kind);
            Level before = trial.level();
            trial.click(new Vec3(1, 0, -2));
            assertEquals(7, trial.level().solids().size(), kind);
            trial.assertOneSoundStep(before);
        }
    }

    @Test
    void aCloudHasTheExtentThatTheKindSays() {
        for (String kind : List.of("volume", "layer")) {
            ToolTrial trial = hall("environment.clouds", kind);
            trial.click(new Vec3(1, 0, -2));
            assertEquals(
                    kind,
                    trial.level()
                            .environment()
                            .clouds()
                            .get(0)
                            .extent()
                            .getClass()
                            .getSimpleName()
                            .toLowerCase(Locale.ROOT));
        }
    }

    @Test
    void aCloudFloatsAboveTheFloor() {
        ToolTrial trial = hall("environment.clouds", "volume");
        trial.click(new Vec3(1, 0, -2));
        Cloud cloud = trial.level().environment().clouds().get(0);
        assertEquals(new Cloud.Extent.Volume(new Vec3(1, 68, -2), new Vec3(40, 16, 40)), cloud.extent());
    }

    @Test
    void withoutASurfaceTheGroundTakesIt() {
        ToolTrial trial = new ToolTrial(DraftLevel.of("\"name\": \"empty\""), PlaceTool::new);
        trial.options().entity("exits", "exit");
        trial.click(new Vec3(1, 0, -2));
        assertEquals(new Vec3(1, 0, -2), trial.level().exits().get(0).feet());
        trial.inPlan(PaneKind.FRONT).click(new Vec3(2, 1, 0));
        assertEquals(new Vec3(2, 1, 0), trial.level().exits().get(1).feet());
    }

    @Test
    void escapeGivesTheLevelBack() {
        ToolTrial trial = hall();
        Level before = trial.level();
        trial.press(new Vec3(1, 0, -2));
        assertEquals(1, trial.level().bodies().size());
        trial.assertCancelled(before);
    }

    @Test
    void anUnknownKindIsTold() {
        ToolTrial trial = hall("bodies", "pyramid");
        Level before = trial.level();
        trial.click(new Vec3(1, 0, -2));
        assertSame(before, trial.level());
        assertEquals(List.of("There is nothing of the kind pyramid in bodies: choose another kind"), trial.messages());
    }
}
