package nephele.engine.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.engine.level.Body;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Problem;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.portal.placement.PlacementSurfaces;
import org.junit.jupiter.api.Test;

/** Mirrors are permitted only on flat faces of solids, and no portal opens on them. */
class MirrorRulesTest {
    private static final Vec3 ONE = new Vec3(1, 1, 1);

    private static Material mirror(String texture, Double roughness, Vec3 emission) {
        return new Material("m", ONE, texture, roughness, null, null, emission, 1, true);
    }

    private static Level level(Material material, List<Solid> solids, List<Body> bodies) {
        return Level.of("", "", null, List.of()).with(List.of(material), solids, bodies);
    }

    private static List<String> paths(Level level) {
        return LevelRules.check(List.of(MirrorRules.FLAT), level, null, null).stream()
                .map(Problem::path)
                .toList();
    }

    private static Solid box(String material, Map<BoxFace, Solid.Face> faces) {
        return new Solid.Box("b", material, true, TextureMapping.WORLD, Vec3.ZERO, new Vec3(4, 4, 4), faces);
    }

    @Test
    void aMirrorHasOnlyABaseColour() {
        assertEquals(List.of(), paths(level(mirror(null, null, Vec3.ZERO), List.of(box("m", Map.of())), List.of())));
        assertEquals(
                List.of("materials[0].texture", "materials[0].roughness", "materials[0].emission"),
                paths(level(mirror("t.png", 0.5, ONE), List.of(), List.of())));
    }

    @Test
    void aBodyIsNoMirror() {
        Body ball = new Body.Sphere("ball", Vec3.ZERO, 1, 1, "m", 0.5, 0);
        assertEquals(
                List.of("bodies[0].material"), paths(level(mirror(null, null, Vec3.ZERO), List.of(), List.of(ball))));
    }

    /** Five faces of a portalable box take portals if the sixth is a mirror, none if all are. */
    @Test
    void noPortalOpensOnAMirror() {
        Material silver = mirror(null, null, Vec3.ZERO);
        Solid one = box(null, Map.of(BoxFace.PLUS_Z, new Solid.Face("m", true, null)));
        assertEquals(
                6,
                PlacementSurfaces.of(StaticShapes.of(level(silver, List.of(box(null, Map.of())), List.of())))
                        .regions());
        assertEquals(
                5,
                PlacementSurfaces.of(StaticShapes.of(level(silver, List.of(one), List.of())))
                        .regions());
        assertEquals(
                0,
                PlacementSurfaces.of(StaticShapes.of(level(silver, List.of(box("m", Map.of())), List.of())))
                        .regions());
    }

    /** A material makes mirrors only if a face of a solid has it. */
    @Test
    void aMirrorIsAFaceOfASolid() {
        Material silver = mirror(null, null, Vec3.ZERO);
        assertFalse(MirrorFaces.any(level(silver, List.of(box(null, Map.of())), List.of())));
        assertTrue(MirrorFaces.any(level(silver, List.of(box("m", Map.of())), List.of())));
    }
}
