package nephele.editor.panel.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.FieldKind;
import nephele.editor.record.ListEdit;
import nephele.engine.level.Material;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class InspectorModelTest {
    private static final EntityRef SLOW = new EntityRef("beacons", "slow");
    private static final EntityRef QUICK = new EntityRef("beacons", "quick");
    private static final EntityRef BRICK = new EntityRef("materials", "brick");
    private static final BeaconLevel LEVEL =
            BeaconLevel.of(BeaconLevel.beacon("slow", 4, "brick"), BeaconLevel.beacon("quick", 1, "brick"));

    private final InspectorModel model = new InspectorModel(Entities.of(BeaconLevel.class));

    private InspectorField field(Record root, String name, EntityRef... refs) {
        return model.fields(root, List.of(refs)).stream()
                .filter(field -> field.path().last().component().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private List<String> names(EntityRef... refs) {
        return model.fields(LEVEL, List.of(refs)).stream()
                .map(field -> field.path().last().component())
                .toList();
    }

    @Test
    void anEntityIsShownByItsRecordAlone() {
        assertEquals(
                List.of("id", "position", "periodSeconds", "portalable", "gain", "material", "flashes", "weights"),
                names(SLOW));
        InspectorField period = field(LEVEL, "periodSeconds", SLOW);
        assertEquals(4.0, period.value());
        assertEquals("period", period.title());
        assertEquals("s", period.type().field().unit());
        assertEquals("0.5 … 8", period.type().range());
        assertEquals(FieldKind.REFERENCE, field(LEVEL, "material", SLOW).type().kind());
        assertEquals(List.of("brick"), model.ids(LEVEL, "materials"));
    }

    @Test
    void theLevelIsShownWithoutItsEntities() {
        assertEquals(List.of("name"), names(InspectorModel.ROOT.get(0)));
    }

    @Test
    void manyShowTheUnionAndWhatDiffersIsMixed() {
        assertEquals(1, names(SLOW, BRICK).stream().filter("material"::equals).count());
        assertTrue(names(SLOW, BRICK).containsAll(List.of("periodSeconds", "baseColour")));
        assertFalse(names(SLOW, BRICK).contains("id"));
        InspectorField period = field(LEVEL, "periodSeconds", SLOW, QUICK);
        assertTrue(period.isMixed());
        assertNull(period.value());
        assertEquals(Arrays.asList(4.0, 1.0), period.values());
        assertFalse(field(LEVEL, "material", SLOW, QUICK).isMixed());
        assertFalse(field(LEVEL, "periodSeconds", SLOW, BRICK).isMixed());
    }

    @Test
    void aValueIsSetWhereItExists() {
        var refs = List.of(SLOW, QUICK, BRICK);
        var after = (BeaconLevel) model.set(LEVEL, refs, field(LEVEL, "periodSeconds", SLOW, QUICK), 3.0);
        assertEquals(3, after.beacons().get(0).periodSeconds());
        assertEquals(3, after.beacons().get(1).periodSeconds());
        assertEquals(LEVEL.materials().get(0), after.materials().get(0));
    }

    @Test
    void resetGivesTheAbsentValue() {
        InspectorField period = field(LEVEL, "periodSeconds", SLOW);
        assertTrue(period.canReset());
        var after = (BeaconLevel) model.reset(LEVEL, List.of(SLOW), period);
        assertEquals(2, after.beacons().get(0).periodSeconds());
        assertFalse(field(after, "periodSeconds", SLOW).canReset());
        assertFalse(field(LEVEL, "position", SLOW).canReset());
    }

    @Test
    void aValueOutOfRangeIsRefusedInWords() {
        InspectorField period = field(LEVEL, "periodSeconds", SLOW);
        assertEquals(
                "Period must be from 0.5 to 8 s",
                model.problem(LEVEL, List.of(SLOW), period, 9.0).orElseThrow().english());
        assertTrue(model.problem(LEVEL, List.of(SLOW), period, 8.0).isEmpty());
        InspectorField id = field(LEVEL, "id", SLOW);
        assertTrue(model.problem(LEVEL, List.of(SLOW), id, "quick").isPresent());
        assertTrue(model.problem(LEVEL, List.of(SLOW), id, "slow").isEmpty());
        assertTrue(model.problem(LEVEL, List.of(SLOW), id, "").isPresent());
    }

    @Test
    void aRenamedRecordKeepsItsUsers() {
        var after = (BeaconLevel) model.set(LEVEL, List.of(BRICK), field(LEVEL, "id", BRICK), "clay");
        assertEquals("clay", after.materials().get(0).id());
        assertEquals("clay", after.beacons().get(1).material());
    }

    @Test
    void anAbsentValueIsSetAndUnset() {
        InspectorField gain = field(LEVEL, "gain", SLOW);
        assertTrue(gain.isUnset() && gain.type().isNullable());
        Record set = model.set(LEVEL, List.of(SLOW), gain, gain.type().freshValue());
        assertEquals(1.0, field(set, "gain", SLOW).value());
        assertEquals(LEVEL, model.reset(set, List.of(SLOW), gain));
    }

    @Test
    void listsAndTablesGetAndLoseEntries() {
        var refs = List.of(SLOW);
        Record added = model.added(LEVEL, refs, field(LEVEL, "flashes", SLOW), null);
        added = model.added(added, refs, field(LEVEL, "weights", SLOW), "night");
        var beacon = ((BeaconLevel) added).beacons().get(0);
        assertEquals(List.of(new Vec3(1, 1, 1)), beacon.flashes());
        assertEquals(Map.of("night", 1.0), beacon.weights());
        List<InspectorField> entries = model.fields(added, refs).stream()
                .filter(InspectorField::isEntry)
                .toList();
        assertEquals(
                List.of("1", "night"),
                entries.stream().map(InspectorField::title).toList());
        Record edited = model.set(added, refs, entries.get(1), 7.0);
        assertEquals(
                Map.of("night", 7.0), ((BeaconLevel) edited).beacons().get(0).weights());
        Record left = model.listEdited(edited, refs, entries.get(0), ListEdit.removed(0));
        left = model.removed(left, refs, entries.get(1));
        assertEquals(LEVEL, left);
    }

    @Test
    void colourIsAWordOfTheName() {
        assertTrue(field(LEVEL, "baseColour", BRICK).type().isColour());
        assertTrue(field(LEVEL, "emission", BRICK).type().isColour());
        assertFalse(field(LEVEL, "position", SLOW).type().isColour());
        assertEquals(Material.class, LEVEL.materials().get(0).getClass());
    }
}
