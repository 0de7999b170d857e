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
class FaceLooksTest {
    private static final Solid.Prism PRISM =
            new Solid.Prism("p", "brick", false, TextureMapping.WORLD, Vec3.ZERO, 1, 2, 6, Map.of());

    @Test
    void oneFaceChangesAndTheOthersStay() {
        RandomSolids solids = new RandomSolids(60);
        for (int i = 0; i < 120; i++) {
            Solid solid = solids.next();
            List<Solid.Face> looks = new ArrayList<>(FaceLooks.of(solid));
            int face = solids.random().nextInt(looks.size());
            String material = List.of("brick", "tile", "metal").get(i % 3);
            boolean portalable = i % 2 == 0;
            Solid changed = FaceLooks.withPortalable(FaceLooks.withMaterial(solid, face, material), face, portalable);
            looks.set(face, new Solid.Face(material, portalable, null));
            assertEquals(looks, FaceLooks.of(changed), solid.toString());
            assertEquals(volume(solid), volume(changed), 1e-9 * volume(solid));
            assertAccepted(List.of(changed));
        }
    }

    @Test
    void whatEqualsTheDefaultIsNotWritten() {
        Solid.Box box = SolidShape.box("b", Vec3.ZERO, new Vec3(1, 1, 1));
        Solid.Box tiled = (Solid.Box) FaceLooks.withMaterial(box, 4, "tile");
        assertEquals(1, tiled.faces().size());
        assertEquals(box, FaceLooks.withMaterial(tiled, 4, "brick"));
        assertSame(tiled, FaceLooks.withPortalable(tiled, 4, false));
        assertEquals(Map.of(), ((Solid.Box) FaceLooks.withMaterial(tiled, "tile")).faces());
    }

    @Test
    void aPrismWithOneOtherFaceStaysAPrism() {
        assertSame(PRISM, FaceLooks.withMaterial(PRISM, 3, "brick"));
        Solid tiled = FaceLooks.withMaterial(PRISM, 3, "tile");
        assertInstanceOf(Solid.Prism.class, tiled);
        assertEquals("tile", FaceLooks.of(tiled).get(3).material());
        Solid plain = FaceLooks.withMaterial(tiled, 3, "brick");
        assertEquals(PRISM, plain);
        Solid metal = FaceLooks.withMaterial(PRISM, "metal");
        assertEquals("metal", assertInstanceOf(Solid.Prism.class, metal).material());
    }

    @Test
    void aGreyFaceMakesGreyTheDefault() {
        Solid.Box box = SolidShape.box("b", Vec3.ZERO, new Vec3(1, 1, 1));
        Solid grey = FaceLooks.withMaterial(box, 2, null);
        assertEquals(null, FaceLooks.of(grey).get(2).material());
        assertEquals(
                5,
                FaceLooks.of(grey).stream()
                        .filter(look -> "brick".equals(look.material()))
                        .count());
        assertAccepted(List.of(grey));
    }

    @Test
    void allFacesArePortalableAtOnce() {
        RandomSolids solids = new RandomSolids(61);
        for (int i = 0; i < 40; i++) {
            Solid solid = solids.next();
            Solid all = FaceLooks.withPortalable(solid, true);
            assertEquals(solid.getClass(), all.getClass());
            assertTrue(FaceLooks.of(all).stream().allMatch(Solid.Face::portalable));
            assertEquals(
                    FaceLooks.of(solid).stream().map(Solid.Face::material).toList(),
                    FaceLooks.of(all).stream().map(Solid.Face::material).toList());
        }
    }
}
