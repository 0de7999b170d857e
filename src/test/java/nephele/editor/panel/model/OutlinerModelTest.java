package nephele.editor.panel.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.Set;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.text.EntityWords;
import nephele.engine.level.EditorNotes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class OutlinerModelTest {
    private static final Entities STRUCTURE = Entities.of(BeaconLevel.class);
    private static final BeaconLevel LEVEL =
            BeaconLevel.of(BeaconLevel.beacon("slow", 4, "brick"), BeaconLevel.beacon("quick", 1, null));

    private final OutlinerModel model = new OutlinerModel(STRUCTURE);

    private List<String> keys(EntityStatus status, String query) {
        return model.rows(LEVEL, status, EntityQuery.parse(query, STRUCTURE)).stream()
                .map(OutlinerRow::key)
                .toList();
    }

    @Test
    void sectionsFollowFromTheRecords() {
        assertEquals(
                List.of("materials", "materials/brick", "beacons", "beacons/slow", "beacons/quick"),
                keys(EntityStatus.NONE, ""));
    }

    @Test
    void aQueryLeavesOutWhatDoesNotMatch() {
        assertEquals(List.of("beacons", "beacons/slow"), keys(EntityStatus.NONE, "periodSeconds>2"));
    }

    @Test
    void aFoldedSectionIsOneLine() {
        model.toggleFold("beacons");
        assertEquals(List.of("materials", "materials/brick", "beacons"), keys(EntityStatus.NONE, ""));
        model.toggleFold("beacons");
        assertEquals(5, keys(EntityStatus.NONE, "").size());
    }

    @Test
    void groupsComeFirst() {
        var status = new EntityStatus(
                List.of(new EditorNotes.Group("lamps", List.of("beacons/slow", "beacons/gone"))),
                Set.of("beacons/slow"),
                Set.of());
        List<OutlinerRow> rows = model.rows(LEVEL, status, EntityQuery.ALL);
        assertEquals(
                List.of("#groups", "#groups/lamps", "materials"),
                keys(status, "").subList(0, 3));
        assertEquals(List.of(new EntityRef("beacons", "slow")), rows.get(1).selected());
        assertEquals(true, rows.get(1).state().isHidden());
        model.toggleFold("#groups/lamps");
        assertEquals("#groups/lamps/beacons/slow", keys(status, "").get(2));
    }

    @Test
    void linesOfAnUnchangedSectionStayTheSame() {
        List<OutlinerRow> before = model.rows(LEVEL, EntityStatus.NONE, EntityQuery.ALL);
        var renamed = new BeaconLevel("other", LEVEL.materials(), LEVEL.beacons());
        assertSame(
                before.get(3),
                model.rows(renamed, EntityStatus.NONE, EntityQuery.ALL).get(3));
    }

    @Test
    void thePaletteHasEveryKind() {
        assertEquals(
                List.of(new PaletteEntry("materials", "material"), new PaletteEntry("beacons", "beacon")),
                PaletteEntry.all(STRUCTURE));
        var kinds = PaletteEntry.all(Entities.LEVEL);
        assertEquals(true, kinds.contains(new PaletteEntry("lights", "spot")));
        assertEquals(true, kinds.contains(new PaletteEntry("player", "playerstart")), kinds.toString());
        assertEquals("Spot light", EntityWords.ofKind("lights", "spot").english());
        assertEquals("Beacon", EntityWords.ofKind("beacons", "beacon").english());
        List<String> game = PaletteEntry.below(Entities.LEVEL, EntityWords.Group.PLAY).stream()
                .map(entry -> entry.words().english())
                .toList();
        assertEquals(
                List.of(
                        "Start",
                        "Exit",
                        "Cube",
                        "Ball",
                        "Capsule",
                        "Portal",
                        "Portal gun",
                        "Observer's sphere",
                        "Par of the level",
                        "Landmark",
                        "Hint"),
                game);
        for (PaletteEntry kind : kinds) {
            assertEquals(false, kind.group() == EntityWords.Group.OTHER, kind + " has no heading");
        }
    }
}
