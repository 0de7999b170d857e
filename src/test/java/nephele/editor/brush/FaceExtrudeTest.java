package nephele.editor.brush;

import static nephele.editor.brush.SolidShape.assertAccepted;
import static nephele.editor.brush.SolidShape.bounds;
import static nephele.editor.brush.SolidShape.box;
import static nephele.editor.brush.SolidShape.indexTowards;
import static nephele.editor.brush.SolidShape.volume;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

@Execution(ExecutionMode.CONCURRENT)
class FaceExtrudeTest {
    private static final Solid BOX = box("box", new Vec3(0, 0, 0), new Vec3(4, 3, 2));
    private static final Solid.Wedge WEDGE = new Solid.Wedge(
            "w", "brick", false, TextureMapping.WORLD, Vec3.ZERO, new Vec3(4, 2, 3), BoxFace.PLUS_X, Map.of());

    private static Solid extruded(Solid solid, Vec3 direction, double metres) {
        return FaceExtrude.extruded(solid, indexTowards(solid, direction), metres)
                .result()
                .orElseThrow();
    }

    @ParameterizedTest
    @EnumSource(BoxFace.class)
    void aSideOfABoxMovesAlone(BoxFace side) {
        Vec3 n = side.normal();
        Aabb before = bounds(BOX);
        Aabb after = bounds(extruded(BOX, n, 0.5));
        assertEquals(before.union(before.moved(n.scaled(0.5))), after);
        assertEquals(BOX, extruded(extruded(BOX, n, 0.5), n, -0.5));
    }

    @Test
    void everyFaceMovesByTheDistanceAndTheOthersStay() {
        RandomSolids solids = new RandomSolids(30);
        for (int i = 0; i < 60; i++) {
            Solid solid = solids.next();
            List<Brush.BrushFace> faces = Brush.of(solid).faces();
            int at = solids.random().nextInt(faces.size());
            Brush.BrushFace face = faces.get(at);
            Optional<Solid> result = FaceExtrude.extruded(solid, at, -0.0625).result();
            if (result.isPresent()) {
                double area = ConvexPolyhedron.areaSquareMetres(face.polygon());
                assertTrue(volume(result.get()) < volume(solid));
                Brush.BrushFace now =
                        SolidShape.towards(result.get(), face.plane().normal());
                assertEquals(face.plane().distance() - 0.0625, now.plane().distance(), 1e-9);
                assertEquals(face.material(), now.material());
                assertAccepted(List.of(result.get()));
                Solid back = FaceExtrude.extruded(
                                result.get(),
                                indexTowards(result.get(), face.plane().normal()),
                                0.0625)
                        .result()
                        .orElseThrow();
                boolean isAllThere = FaceLooks.of(back).size() == faces.size();
                assertEquals(volume(solid), volume(back), isAllThere ? 1e-9 * volume(solid) : area);
            }
        }
    }

    @Test
    void theEndsOfAWedgeAndAPrismKeepTheirKind() {
        Solid.Wedge wider = assertInstanceOf(Solid.Wedge.class, extruded(WEDGE, new Vec3(0, 0, 1), 1));
        assertEquals(new Vec3(4, 2, 4), wider.size());
        assertEquals(new Vec3(0, 0, 0.5), wider.centre());
        Solid.Wedge deeper = assertInstanceOf(Solid.Wedge.class, extruded(WEDGE, new Vec3(0, -1, 0), 1));
        assertEquals(new Vec3(6, 3, 3), deeper.size());
        Solid.Prism prism = new Solid.Prism("p", null, false, TextureMapping.WORLD, Vec3.ZERO, 1, 2, 7, Map.of());
        Solid.Prism higher = assertInstanceOf(Solid.Prism.class, extruded(prism, new Vec3(0, 1, 0), 3));
        assertEquals(5, higher.heightMetres());
        assertEquals(new Vec3(0, 1.5, 0), higher.centre());
        assertInstanceOf(Solid.Planes.class, extruded(prism, new Vec3(1, 0, 0), -0.25));
    }

    @Test
    void aSlopePushedInLeavesAWedge() {
        Solid pushed = extruded(WEDGE, new Vec3(-1, 2, 0), -0.5);
        assertTrue(volume(pushed) < volume(WEDGE));
        assertAccepted(List.of(pushed));
    }

    @Test
    void whatWouldBeNothingIsRefused() {
        assertEquals(
                BrushText.NOTHING_LEFT,
                FaceExtrude.extruded(BOX, 2, -3).refusal().orElseThrow());
        assertEquals(
                BrushText.TOO_THIN,
                FaceExtrude.extruded(BOX, 2, -3 + 5e-5).refusal().orElseThrow());
        int bottom = indexTowards(WEDGE, new Vec3(0, -1, 0));
        assertEquals(
                BrushText.NOTHING_LEFT,
                FaceExtrude.extruded(WEDGE, bottom, -2).refusal().orElseThrow());
        Solid frustum = extruded(pyramid(), new Vec3(0, -1, 0), 0.0);
        int top = indexTowards(frustum, new Vec3(0, 1, 0));
        assertEquals(
                BrushText.FACE_VANISHES,
                FaceExtrude.extruded(frustum, top, 2).refusal().orElseThrow());
    }

    /** A truncated pyramid: apex at 2 m, cut at 1 m. */
    private static Solid pyramid() {
        List<Solid.PlaneFace> planes = List.of(
                new Solid.PlaneFace(new Vec3(0, -1, 0), 0, null, null, null),
                new Solid.PlaneFace(new Vec3(0, 1, 0), 1, null, null, null),
                new Solid.PlaneFace(new Vec3(1, 1, 0), Math.sqrt(2), null, null, null),
                new Solid.PlaneFace(new Vec3(-1, 1, 0), Math.sqrt(2), null, null, null),
                new Solid.PlaneFace(new Vec3(0, 1, 1), Math.sqrt(2), null, null, null),
                new Solid.PlaneFace(new Vec3(0, 1, -1), Math.sqrt(2), null, null, null));
        return new Solid.Planes("pyramid", null, false, TextureMapping.WORLD, planes);
    }

    @Test
    void aNewBrushGrowsFromAFaceWithTheLooksAroundIt() {
        Solid tiled = FaceLooks.withMaterial(FaceLooks.withPortalable(BOX, 2, true), 0, "tile");
        List<Solid> both =
                FaceExtrude.extrudedAsNew(tiled, 2, 1.5, "new").result().orElseThrow();
        assertSame(tiled, both.get(0));
        Solid.Box grown = assertInstanceOf(Solid.Box.class, both.get(1));
        assertEquals("new", grown.id());
        assertEquals(new Aabb(0, 3, 0, 4, 4.5, 2), bounds(grown));
        assertEquals(true, FaceLooks.of(grown).get(2).portalable());
        assertEquals("tile", FaceLooks.of(grown).get(0).material());
    }

    @Test
    void growingFromAnyFaceAddsAreaTimesDistanceOutsideTheSolid() {
        RandomSolids solids = new RandomSolids(31);
        for (int i = 0; i < 60; i++) {
            Solid solid = solids.next();
            List<Brush.BrushFace> faces = Brush.of(solid).faces();
            int at = solids.random().nextInt(faces.size());
            Optional<List<Solid>> both =
                    FaceExtrude.extrudedAsNew(solid, at, 0.75, "new").result();
            if (both.isPresent()) {
                Solid grown = both.get().get(1);
                double volume =
                        0.75 * ConvexPolyhedron.areaSquareMetres(faces.get(at).polygon());
                assertEquals(volume, volume(grown), 1e-8 * Math.max(1, volume), solid.toString());
                assertTrue(BrushBoolean.intersected(solid, grown).result().isEmpty());
                assertAccepted(both.get());
            } else {
                assertTrue(ConvexPolyhedron.areaSquareMetres(faces.get(at).polygon()) < 1e-2);
            }
        }
    }

    @Test
    void aNegativeDistanceSplitsTheSolid() {
        List<Solid> parts =
                FaceExtrude.extrudedAsNew(BOX, 2, -1, "new").result().orElseThrow();
        assertEquals(new Aabb(0, 0, 0, 4, 2, 2), bounds(parts.get(0)));
        assertEquals(new Aabb(0, 2, 0, 4, 3, 2), bounds(parts.get(1)));
        assertEquals(List.of("box", "new"), parts.stream().map(Solid::id).toList());
    }
}
