package nephele.editor.brush;

import static nephele.editor.brush.SolidShape.assertAccepted;
import static nephele.editor.brush.SolidShape.volume;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class SolidFacesTest {
    private static final Solid.Prism PRISM =
            new Solid.Prism("p", "brick", false, TextureMapping.WORLD, Vec3.ZERO, 1, 2, 6);

    @Test
    void oneFaceChangesAndTheOthersStay() {
        RandomSolids solids = new RandomSolids(60);
        for (int i = 0; i < 120; i++) {
            Solid solid = solids.next();
            List<Solid.Face> looks = new ArrayList<>(SolidFaces.of(solid));
            int face = solids.random().nextInt(looks.size());
            String material = List.of("brick", "tile", "metal").get(i % 3);
            boolean portalable = i % 2 == 0;
            Solid changed = SolidFaces.withPortalable(SolidFaces.withMaterial(solid, face, material), face, portalable);
            looks.set(face, new Solid.Face(material, portalable));
            assertEquals(looks, SolidFaces.of(changed), solid.toString());
            assertEquals(volume(solid), volume(changed), 1e-9 * volume(solid));
            assertAccepted(List.of(changed));
        }
    }

    @Test
    void whatEqualsTheDefaultIsNotWritten() {
        Solid.Box box = SolidShape.box("b", Vec3.ZERO, new Vec3(1, 1, 1));
        Solid.Box tiled = (Solid.Box) SolidFaces.withMaterial(box, 4, "tile");
        assertEquals(1, tiled.faces().size());
        assertEquals(box, SolidFaces.withMaterial(tiled, 4, "brick"));
        assertSame(tiled, SolidFaces.withPortalable(tiled, 4, false));
        assertEquals(Map.of(), ((Solid.Box) SolidFaces.withMaterial(tiled, "tile")).faces());
    }

    @Test
    void aPrismWithOneOtherFaceIsWrittenAsPlanes() {
        assertSame(PRISM, SolidFaces.withMaterial(PRISM, 3, "brick"));
        Solid tiled = SolidFaces.withMaterial(PRISM, 3, "tile");
        assertInstanceOf(Solid.Planes.class, tiled);
        assertEquals("tile", SolidFaces.of(tiled).get(3).material());
        Solid plain = SolidFaces.withMaterial(tiled, 3, "brick");
        assertEquals(PRISM, Simplified.of((Solid.Planes) plain));
        Solid metal = SolidFaces.withMaterial(PRISM, "metal");
        assertEquals("metal", assertInstanceOf(Solid.Prism.class, metal).material());
    }

    @Test
    void aGreyFaceMakesGreyTheDefault() {
        Solid.Box box = SolidShape.box("b", Vec3.ZERO, new Vec3(1, 1, 1));
        Solid grey = SolidFaces.withMaterial(box, 2, null);
        assertEquals(null, SolidFaces.of(grey).get(2).material());
        assertEquals(
                5,
                SolidFaces.of(grey).stream()
                        .filter(look -> "brick".equals(look.material()))
                        .count());
        assertAccepted(List.of(grey));
    }

    @Test
    void allFacesArePortalableAtOnce() {
        RandomSolids solids = new RandomSolids(61);
        for (int i = 0; i < 40; i++) {
            Solid solid = solids.next();
            Solid all = SolidFaces.withPortalable(solid, true);
            assertEquals(solid.getClass(), all.getClass());
            assertTrue(SolidFaces.of(all).stream().allMatch(Solid.Face::portalable));
            assertEquals(
                    SolidFaces.of(solid).stream().map(Solid.Face::material).toList(),
                    SolidFaces.of(all).stream().map(Solid.Face::material).toList());
        }
    }
}
