package nephele.editor.brush;

import static nephele.editor.brush.SolidShape.assertAccepted;
import static nephele.editor.brush.SolidShape.bounds;
import static nephele.editor.brush.SolidShape.box;
import static nephele.editor.brush.SolidShape.depth;
import static nephele.editor.brush.SolidShape.volume;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
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
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class BrushBooleanTest {
    private static final int CASES = 40;
    private static final int POINTS = 100;

    /** Nearer to a surface, rounding may decide on which side a point is. */
    private static final double NEAR_METRES = 1e-7;

    private static Supplier<String> ids() {
        AtomicInteger next = new AtomicInteger();
        return () -> "new " + next.incrementAndGet();
    }

    private static List<Solid> subtracted(Solid solid, Solid cutter) {
        return BrushBoolean.subtracted(solid, cutter, ids()).result().orElseThrow();
    }

    @Test
    void differenceAndIntersectionConserveVolumeAndHoldTheRightPoints() {
        RandomSolids solids = new RandomSolids(1);
        int overlapping = 0;
        for (int i = 0; i < CASES; i++) {
            Solid a = solids.next();
            Solid b = solids.next();
            List<Solid> pieces = subtracted(a, b);
            Optional<Solid> common = BrushBoolean.intersected(a, b).result();
            double commonVolume = common.map(SolidShape::volume).orElse(0.0);
            overlapping += common.isPresent() ? 1 : 0;
            assertEquals(volume(a), volume(pieces) + commonVolume, 1e-9 * volume(a), a + " minus " + b);
            assertPoints(solids, a, b, pieces, common);
            assertAccepted(pieces);
            common.ifPresent(solid -> assertAccepted(List.of(solid)));
        }
        assertTrue(overlapping > CASES / 2, overlapping + " overlap");
    }

    private static void assertPoints(
            RandomSolids solids, Solid a, Solid b, List<Solid> pieces, Optional<Solid> common) {
        Brush first = Brush.of(a);
        Brush second = Brush.of(b);
        List<Brush> parts = pieces.stream().map(Brush::of).toList();
        Optional<Brush> both = common.map(Brush::of);
        Aabb around = bounds(a).grown(0.5);
        for (int i = 0; i < POINTS; i++) {
            Vec3 p = SolidShape.pointIn(around, solids.random());
            double inA = depth(first, p);
            double inB = depth(second, p);
            boolean isNear = Math.min(Math.abs(inA), Math.abs(inB)) < NEAR_METRES;
            boolean isBetween = parts.stream().anyMatch(part -> Math.abs(depth(part, p)) < NEAR_METRES);
            if (!isNear && !isBetween) {
                long holding = parts.stream().filter(part -> depth(part, p) < 0).count();
                assertEquals(inA < 0 && inB > 0 ? 1 : 0, holding, p + " in " + a + " minus " + b);
                boolean inCommon =
                        common.map(solid -> depth(Brush.of(solid), p) < 0).orElse(false);
                assertEquals(inA < 0 && inB < 0, inCommon, p + " in both");
            }
        }
    }

    @Test
    void aDoorwayLeavesThreeBoxesAroundIt() {
        Solid wall = box("wall", new Vec3(0, 0, 0), new Vec3(4, 3, 0.25));
        Solid door = box("door", new Vec3(1, 0, -1), new Vec3(2, 2, 1));
        List<Solid> pieces = subtracted(wall, door);
        assertEquals(
                List.of("wall", "new 1", "new 2"),
                pieces.stream().map(Solid::id).toList());
        pieces.forEach(piece -> assertInstanceOf(Solid.Box.class, piece));
        assertEquals(4 * 3 * 0.25 - 2 * 0.25, volume(pieces), 1e-12);
    }

    @Test
    void touchingAndCoplanarSolidsDoNotCut() {
        Solid a = box("a", Vec3.ZERO, new Vec3(1, 1, 1));
        for (Vec3 at : List.of(new Vec3(1, 0, 0), new Vec3(1, 1, 0), new Vec3(-1, -1, -1), new Vec3(0, 5, 0))) {
            Solid b = SolidTransform.moved(a, at);
            assertSame(a, subtracted(a, b).get(0));
            assertEquals(
                    BrushText.NO_OVERLAP,
                    BrushBoolean.intersected(a, b).refusal().orElseThrow());
        }
        assertEquals(List.of(), subtracted(a, a));
        assertEquals(a, BrushBoolean.intersected(a, a).result().orElseThrow());
    }

    @Test
    void anOverlapThinnerThanATenthOfAMillimetreCutsNothing() {
        Solid a = box("a", Vec3.ZERO, new Vec3(1, 1, 1));
        Solid b = SolidTransform.moved(a, new Vec3(1 - 5e-5, 0, 0));
        assertSame(a, subtracted(a, b).get(0));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e3, 1e6})
    void boxesFarFromTheOriginAreCutIntoBoxes(double far) {
        Vec3 at = new Vec3(far, -far, far);
        Solid a = SolidTransform.moved(box("a", Vec3.ZERO, new Vec3(4, 4, 4)), at);
        Solid b = SolidTransform.moved(box("b", new Vec3(1, 1, 1), new Vec3(2, 2, 2)), at);
        List<Solid> pieces = subtracted(a, b);
        assertEquals(6, pieces.size());
        pieces.forEach(piece -> assertInstanceOf(Solid.Box.class, piece));
        assertEquals(63, volume(pieces), 1e-9 * 63);
        assertAccepted(pieces);
    }

    /** A thousand kilometres out the engine welds corners nearer than 2 mm, so that some pieces cannot be made. */
    @Test
    void farFromTheOriginNothingIsLostSilently() {
        RandomSolids solids = new RandomSolids(11);
        Vec3 far = new Vec3(1e6, -1e5, 3e3);
        int done = 0;
        for (int i = 0; i < CASES; i++) {
            Solid a = SolidTransform.moved(turned(solids), far);
            Solid b = SolidTransform.moved(turned(solids), far);
            boolean isValid =
                    BrushCheck.refusal(a).isEmpty() && BrushCheck.refusal(b).isEmpty();
            BrushEdit<List<Solid>> edit = isValid ? BrushBoolean.subtracted(a, b, ids()) : BrushEdit.done(List.of());
            if (isValid && edit.result().isPresent()) {
                double common = BrushBoolean.intersected(a, b)
                        .result()
                        .map(SolidShape::volume)
                        .orElse(0.0);
                assertEquals(volume(a), volume(edit.result().get()) + common, 1e-6 * volume(a));
                done++;
            }
            assertTrue(edit.refusal().filter(why -> why != BrushText.NOT_SOLID).isEmpty());
        }
        assertTrue(done > CASES / 2, done + " subtracted");
    }

    private static Solid turned(RandomSolids solids) {
        return SolidTransform.rotated(solids.next(), Vec3.ZERO, solids.direction(), 30)
                .result()
                .orElseThrow();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1, 1e4})
    void piecesFillTheDifferenceAtAnySize(double scale) {
        Vec3 factors = new Vec3(scale, scale, scale);
        RandomSolids solids = new RandomSolids(3);
        for (int i = 0; i < 10; i++) {
            Solid a = SolidTransform.scaled(solids.next(), Vec3.ZERO, factors)
                    .result()
                    .orElseThrow();
            Solid b = SolidTransform.scaled(solids.next(), Vec3.ZERO, factors)
                    .result()
                    .orElseThrow();
            double common = BrushBoolean.intersected(a, b)
                    .result()
                    .map(SolidShape::volume)
                    .orElse(0.0);
            // A weld of corners moves them by up to 1e-9 m, and slivers below 0.1 mm are dropped.
            double slack = scale < 1 ? 1e-3 : 1e-9;
            assertEquals(volume(a), volume(subtracted(a, b)) + common, slack * volume(a));
        }
    }

    @Test
    void mergingTheHalvesGivesTheWhole() {
        RandomSolids solids = new RandomSolids(4);
        for (int i = 0; i < CASES; i++) {
            Solid whole = solids.next();
            Vec3 middle = bounds(whole).centre();
            var cut = Plane.through(Plane.of(solids.direction(), 0).normal(), middle);
            Optional<List<Solid>> halves = BrushClip.clipped(
                            whole, cut, BrushClip.Keep.BOTH, new Solid.Face(null, null, null), "front")
                    .result();
            if (halves.isPresent()) {
                Solid merged = BrushBoolean.merged(halves.get()).result().orElseThrow();
                assertEquals(volume(whole), volume(merged), 1e-9 * volume(whole), whole.toString());
                assertEquals(FaceLooks.of(whole).size(), FaceLooks.of(merged).size(), whole + " cut by " + cut);
                assertTrue(BrushBoolean.isUnionConvex(halves.get()));
                assertAccepted(List.of(merged));
            }
        }
    }

    @Test
    void mergedBoxesBecomeOneBoxAndKeepTheirFaces() {
        Solid left = FaceLooks.withMaterial(box("left", Vec3.ZERO, new Vec3(1, 1, 1)), 1, "tile");
        Solid right = FaceLooks.withPortalable(box("right", new Vec3(1, 0, 0), new Vec3(3, 1, 1)), 0, true);
        Solid merged = BrushBoolean.merged(List.of(left, right)).result().orElseThrow();
        assertInstanceOf(Solid.Box.class, merged);
        assertEquals("left", merged.id());
        assertEquals(new Aabb(0, 0, 0, 3, 1, 1), bounds(merged));
        assertEquals("tile", FaceLooks.of(merged).get(1).material());
        assertEquals(true, FaceLooks.of(merged).get(0).portalable());
    }

    @Test
    void aGreyFaceStaysGreyInAHullWithAnotherDefault() {
        Solid brick = box("a", Vec3.ZERO, new Vec3(1, 1, 1));
        Solid grey = FaceLooks.withMaterial(box("b", new Vec3(1, 0, 0), new Vec3(2, 1, 1)), null);
        Solid merged = BrushBoolean.merged(List.of(brick, grey)).result().orElseThrow();
        assertEquals(null, FaceLooks.of(merged).get(0).material());
        assertEquals("brick", FaceLooks.of(merged).get(1).material());
    }

    @Test
    void aUnionWithANotchIsNotConvex() {
        Solid a = box("a", Vec3.ZERO, new Vec3(1, 1, 1));
        Solid higher = box("b", new Vec3(1, 0, 0), new Vec3(2, 1.5, 1));
        assertFalse(BrushBoolean.isUnionConvex(List.of(a, higher)));
        Solid overlapping = box("b", new Vec3(0.5, 0, 0), new Vec3(2, 1, 1));
        assertTrue(BrushBoolean.isUnionConvex(List.of(a, overlapping)));
    }

    @Test
    void aHullOfTooManyFacesIsRefused() {
        Solid.Prism round = new Solid.Prism("p", null, false, TextureMapping.WORLD, Vec3.ZERO, 2, 1, 40, Map.of());
        Solid turned = SolidTransform.rotated(round, Vec3.ZERO, new Vec3(1, 0, 0), 90)
                .result()
                .orElseThrow();
        assertEquals(
                BrushText.TOO_MANY_FACES,
                BrushBoolean.merged(List.of(round, turned)).refusal().orElseThrow());
        assertEquals(
                BrushText.NO_BRUSHES, BrushBoolean.merged(List.of()).refusal().orElseThrow());
    }

    @Test
    void roundSolidsOf62SidesCutEachOther() {
        Solid.Prism round = new Solid.Prism("p", null, false, TextureMapping.WORLD, Vec3.ZERO, 2, 1, 30, Map.of());
        Solid other = SolidTransform.moved(round, new Vec3(1, 0.5, 0.25));
        List<Solid> pieces = new ArrayList<>(subtracted(round, other));
        double common = volume(BrushBoolean.intersected(round, other).result().orElseThrow());
        assertEquals(volume(round), volume(pieces) + common, 1e-9 * volume(round));
    }
}
