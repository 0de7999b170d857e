package nephele.editor.brush;

import static nephele.editor.brush.SolidShape.assertAccepted;
import static nephele.editor.brush.SolidShape.bounds;
import static nephele.editor.brush.SolidShape.box;
import static nephele.editor.brush.SolidShape.depth;
import static nephele.editor.brush.SolidShape.volume;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import nephele.editor.brush.BrushClip.Keep;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class BrushClipTest {
    private static final Solid.Face METAL = new Solid.Face("metal", true, null);
    private static final Solid UNIT = box("unit", Vec3.ZERO, new Vec3(2, 2, 2));

    private static BrushEdit<List<Solid>> clipped(Solid solid, Plane plane) {
        return BrushClip.clipped(solid, plane, Keep.BOTH, METAL, "front");
    }

    private static Plane plane(Vec3 normal, Vec3 through) {
        return Plane.through(Plane.of(normal, 0).normal(), through);
    }

    @Test
    void theHalvesTileTheSolidAndFacesKeepTheirLook() {
        RandomSolids solids = new RandomSolids(20);
        int cut = 0;
        for (int i = 0; i < 100; i++) {
            Solid solid = solids.next();
            Plane plane = plane(solids.direction(), SolidShape.pointIn(bounds(solid), solids.random()));
            BrushEdit<List<Solid>> edit = clipped(solid, plane);
            if (edit.result().isPresent()) {
                cut++;
                List<Solid> halves = edit.result().get();
                assertEquals(volume(solid), volume(halves), 1e-9 * volume(solid), solid + " by " + plane);
                assertAccepted(halves);
                assertPointsAndLooks(solids, solid, plane, halves);
            }
        }
        assertTrue(cut > 70, cut + " cut");
    }

    private static void assertPointsAndLooks(RandomSolids solids, Solid solid, Plane plane, List<Solid> halves) {
        Brush whole = Brush.of(solid);
        Brush behind = Brush.of(halves.get(0));
        Brush front = Brush.of(halves.get(1));
        for (int i = 0; i < 60; i++) {
            Vec3 p = SolidShape.pointIn(bounds(solid), solids.random());
            double side = plane.signedDistance(p);
            if (Math.abs(side) > 1e-7 && Math.abs(depth(whole, p)) > 1e-7) {
                assertEquals(depth(whole, p) < 0 && side < 0, depth(behind, p) < 0);
                assertEquals(depth(whole, p) < 0 && side > 0, depth(front, p) < 0);
            }
        }
        for (Brush half : List.of(behind, front)) {
            for (Brush.BrushFace face : half.faces()) {
                Brush.BrushFace before = SolidShape.towards(solid, face.plane().normal());
                boolean isOld = SimplestSolid.isSame(before.plane(), face.plane());
                assertEquals(isOld ? before.material() : "metal", face.material());
                assertEquals(!isOld || before.portalable(), face.portalable());
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"BEHIND, unit, 0", "IN_FRONT, unit, 1"})
    void aPartThatStaysAloneKeepsTheId(Keep keep, String id, double from) {
        List<Solid> kept = BrushClip.clipped(UNIT, plane(new Vec3(0, 1, 0), new Vec3(0, 1, 0)), keep, METAL, "front")
                .result()
                .orElseThrow();
        assertEquals(List.of(id), kept.stream().map(Solid::id).toList());
        assertEquals(new Aabb(0, from, 0, 2, from + 1, 2), bounds(kept.get(0)));
        assertInstanceOf(Solid.Box.class, kept.get(0));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-5, -1e-5, 5e-5, -1, 2.5, 2})
    void aPlaneBesideOrOnAFaceIsRefused(double at) {
        Plane plane = plane(new Vec3(0, 1, 0), new Vec3(0, at, 0));
        BrushText why = at > 0 && at < 1 ? BrushText.TOO_THIN : BrushText.PLANE_MISSES;
        assertEquals(why, clipped(UNIT, plane).refusal().orElseThrow());
    }

    @Test
    void aPlaneThroughAnEdgeOrAVertexAloneIsRefused() {
        Plane edge = plane(new Vec3(1, 1, 0), new Vec3(2, 2, 0));
        Plane vertex = plane(new Vec3(1, 1, 1), new Vec3(2, 2, 2));
        assertEquals(BrushText.PLANE_MISSES, clipped(UNIT, edge).refusal().orElseThrow());
        assertEquals(BrushText.PLANE_MISSES, clipped(UNIT, vertex).refusal().orElseThrow());
    }

    @Test
    void aPlaneThroughOppositeEdgesMakesTwoHalvesOfWhichOneIsAWedge() {
        List<Solid> halves =
                clipped(UNIT, plane(new Vec3(-1, 1, 0), Vec3.ZERO)).result().orElseThrow();
        Solid.Wedge wedge = assertInstanceOf(Solid.Wedge.class, halves.get(0));
        assertEquals(BoxFace.PLUS_X, wedge.rising());
        assertEquals(new Vec3(1, 1, 1), wedge.centre());
        assertEquals(METAL, wedge.faces().get("slope"));
        assertEquals(4, volume(halves.get(1)), 1e-12);
    }

    @Test
    void aPlaneThroughThreeVerticesMakesACorner() {
        List<Solid> halves = clipped(UNIT, plane(new Vec3(1, 1, 1), new Vec3(2, 2, 0)))
                .result()
                .orElseThrow();
        assertEquals(4, Brush.of(halves.get(1)).faces().size());
        assertEquals(8 / 6.0, volume(halves.get(1)), 1e-9);
        assertEquals(7, Brush.of(halves.get(0)).shape().vertices().size());
    }

    @Test
    void aFlatCutOfAPrismIsAPrismAgain() {
        Solid.Prism prism = new RandomSolids(21).prism();
        Vec3 top = prism.centre();
        List<Solid> halves =
                clipped(prism, plane(new Vec3(0, 1, 0), top)).result().orElseThrow();
        Solid.Prism cut = assertInstanceOf(Solid.Prism.class, halves.get(0));
        assertEquals(Set.of("+y"), cut.faces().keySet());
        assertEquals(METAL, FaceLooks.of(cut).get(0));
        List<Solid> same = BrushClip.clipped(
                        prism, plane(new Vec3(0, 1, 0), top), Keep.BOTH, new Solid.Face(null, null, null), "front")
                .result()
                .orElseThrow();
        Solid.Prism lower = assertInstanceOf(Solid.Prism.class, same.get(0));
        assertEquals(prism.heightMetres() / 2, lower.heightMetres());
        assertEquals(prism.radiusMetres(), lower.radiusMetres());
        assertEquals(prism.sides(), lower.sides());
    }

    @Test
    void aCutThatNeeds65FacesIsRefused() {
        Solid.Prism round = new Solid.Prism("p", null, false, TextureMapping.WORLD, Vec3.ZERO, 2, 1, 62, Map.of());
        Plane chamfer = plane(new Vec3(1, 1, 0), new Vec3(1.9, 0.5, 0));
        assertEquals(
                BrushText.TOO_MANY_FACES,
                BrushClip.clipped(round, chamfer, Keep.BEHIND, METAL, "front")
                        .refusal()
                        .orElseThrow());
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e6})
    void solidsFarFromTheOriginAreCut(double far) {
        Solid there = SolidTransform.moved(UNIT, new Vec3(far, 0, -far));
        Plane plane = plane(new Vec3(1, 2, 3), new Vec3(far + 1, 1, 1 - far));
        List<Solid> halves = clipped(there, plane).result().orElseThrow();
        assertEquals(8, volume(halves), 8 * 1e-15 * far + 1e-9);
        halves.forEach(half -> assertEquals(Optional.empty(), BrushCheck.refusal(half)));
    }
}
