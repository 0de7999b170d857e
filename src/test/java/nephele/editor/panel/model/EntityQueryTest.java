package nephele.editor.panel.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import nephele.editor.added.AddedRecord;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Light;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class EntityQueryTest {
    private static final EntityRef WALL = new EntityRef("solids", "north-wall");
    private static final EntityRef LAMP = new EntityRef("lights", "lamp");
    private static final Record BOX = new Solid.Box(
            "north-wall", "brick", true, TextureMapping.WORLD, Vec3.ZERO, new Vec3(1, 5, 1), java.util.Map.of());
    private static final Record LIGHT = AddedRecord.at(RecordKind.of(Light.Point.class), "lamp", new Vec3(1, 2, 3));
    private static final EntityStatus STATUS =
            new EntityStatus(List.of(), Set.of("solids/north-wall"), Set.of("lights/lamp"));

    private static String matches(String text) {
        EntityQuery query = EntityQuery.parse(text, Entities.LEVEL);
        assertEquals(List.of(), query.errors(), text);
        return (query.matches(WALL, BOX, STATUS) ? "wall " : "") + (query.matches(LAMP, LIGHT, STATUS) ? "lamp" : "");
    }

    private static String error(String text) {
        return EntityQuery.parse(text, Entities.LEVEL).errors().get(0).english();
    }

    @Test
    void wordsAreBoundByAnd() {
        assertEquals("wall lamp", matches(""));
        assertEquals("wall ", matches("North"));
        assertEquals("wall ", matches("material:brick portalable:true size>4"));
        assertEquals("", matches("material:brick portalable:false"));
        assertEquals("", matches("north lamp"));
    }

    @Test
    void typesAreKindsAndSections() {
        assertEquals("wall ", matches("type:box"));
        assertEquals("lamp", matches("type:light"));
        assertEquals("lamp", matches("type:lights"));
        assertEquals("lamp", matches("type:point"));
        assertEquals("", matches("type:spot"));
    }

    @Test
    void aVectorCountsWithItsGreatestComponent() {
        assertEquals("wall ", matches("size>4"));
        assertEquals("", matches("size>5"));
        assertEquals("wall ", matches("size>=5"));
        assertEquals("lamp", matches("rangeMetres<21"));
        assertEquals("", matches("rangeMetres<20"));
        assertEquals("lamp", matches("rangeMetres<=20"));
        assertEquals("lamp", matches("rangeMetres=20"));
    }

    @Test
    void hiddenAndLockedAreOfTheNotes() {
        assertEquals("wall ", matches("hidden:true"));
        assertEquals("lamp", matches("hidden:false"));
        assertEquals("lamp", matches("locked:true"));
    }

    @Test
    void whatIsWrongIsSaid() {
        assertEquals("no entity has a component \"flavour\"", error("flavour:red"));
        assertEquals("size> compares with a number, not with \"big\"", error("size>big"));
        assertEquals("size: write a value after it".replace("size:", "size::"), error("size:"));
        assertEquals("hidden: write true or false", error("hidden:no"));
    }

    @Test
    void anEntityIsFoundByItsRecordAlone() {
        Entities entities = Entities.of(BeaconLevel.class);
        Record root = BeaconLevel.of(BeaconLevel.beacon("slow", 4, "brick"), BeaconLevel.beacon("quick", 1, null));
        EntityQuery query = EntityQuery.parse("periodSeconds>2 material:brick type:beacon", entities);
        assertEquals(List.of(), query.errors());
        List<EntityRef> found = entities.all(root).stream()
                .filter(ref -> query.matches(ref, entities.find(root, ref).orElseThrow(), EntityStatus.NONE))
                .toList();
        assertEquals(List.of(new EntityRef("beacons", "slow")), found);
    }
}
