package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.json.LevelJsonTest;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class SolidFacesTest {
    private static final TextureMapping WORLD = TextureMapping.WORLD;
    private static final Solid.Face SAID = new Solid.Face("tile", true, new TexturePlacement(0.25, -1, 30, -0.5, 2));

    private static List<Solid> oneOfEachKind() {
        Vec3 size = new Vec3(1, 2, 3);
        List<Solid.PlaneFace> planes = List.of(
                new Solid.PlaneFace(new Vec3(1, 1, 1), 1, null, null, null),
                new Solid.PlaneFace(new Vec3(-1, 0, 0), 0, "brick", null, null),
                new Solid.PlaneFace(new Vec3(0, -1, 0), 0, null, false, null),
                new Solid.PlaneFace(new Vec3(0, 0, -1), 0, null, null, SAID.texture()));
        return List.of(
                new Solid.Box("s", "brick", false, WORLD, Vec3.ZERO, size, Map.of()),
                new Solid.Wedge("s", "brick", false, WORLD, Vec3.ZERO, size, BoxFace.MINUS_Z, Map.of()),
                new Solid.Prism("s", "brick", false, WORLD, Vec3.ZERO, 1, 2, 12, Map.of()),
                new Solid.Planes("s", "brick", false, WORLD, planes));
    }

    @Test
    void namesAreThoseOfTheShape() {
        for (Solid solid : oneOfEachKind()) {
            List<String> ofShape =
                    Brush.of(solid).faces().stream().map(Brush.BrushFace::name).toList();
            assertEquals(new HashSet<>(ofShape), new HashSet<>(SolidFaces.names(solid)));
            assertEquals(ofShape.size(), SolidFaces.names(solid).size());
        }
    }

    @Test
    void whatIsSaidOfAFaceReachesThatFaceAndNoOther() {
        for (Solid solid : oneOfEachKind()) {
            for (String name : SolidFaces.names(solid)) {
                Solid painted = SolidFaces.with(solid, name, SAID);
                assertEquals(SAID, SolidFaces.authored(painted, name));
                for (Brush.BrushFace face : Brush.of(painted).faces()) {
                    Solid.Face other = SolidFaces.authored(solid, face.name());
                    boolean isPainted = face.name().equals(name);
                    assertEquals(isPainted ? SAID.texture() : other.texture(), face.texture(), name);
                    assertEquals(isPainted ? "tile" : "brick", face.material());
                    assertEquals(isPainted, face.portalable());
                }
                assertEquals(solid, SolidFaces.with(painted, name, SolidFaces.authored(solid, name)), name);
            }
        }
    }

    @Test
    void everyFaceIsWrittenAndRead() {
        for (Solid solid : oneOfEachKind()) {
            Solid painted = solid;
            for (String name : SolidFaces.names(solid)) {
                painted = SolidFaces.with(painted, name, SAID);
            }
            Level level = LevelJsonTest.sections("\"materials\": [{\"id\": \"brick\"}, {\"id\": \"tile\"}]")
                    .with(List.of(), List.of(painted), List.of(), List.of());
            assertEquals(level, LevelJsonTest.read(LevelJson.write(level)));
        }
    }

    /** A face without a placement is written as before placements existed. */
    @Test
    void aPlacementThatChangesNothingIsLeftOut() {
        Solid box = oneOfEachKind().get(0);
        assertEquals(box, SolidFaces.with(box, "+x", new Solid.Face(null, null, TexturePlacement.NONE)));
        Solid.Face mapped = new Solid.Face("tile", null, null);
        Level level = LevelJsonTest.sections("\"name\": \"\"")
                .with(List.of(), List.of(SolidFaces.with(box, "+x", mapped)), List.of(), List.of());
        assertEquals(-1, LevelJson.write(level).indexOf("texture"));
    }

    @Test
    void anUnknownFaceIsRefused() {
        Solid prism = oneOfEachKind().get(2);
        assertThrows(IllegalArgumentException.class, () -> SolidFaces.with(prism, "side 12", SAID));
    }
}
