package nephele.editor.brush;

import static nephele.editor.brush.SolidShape.assertAccepted;
import static nephele.editor.brush.SolidShape.bounds;
import static nephele.editor.brush.SolidShape.depth;
import static nephele.editor.brush.SolidShape.volume;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import java.util.Map;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class SolidTransformTest {
    private static final int CASES = 120;
    private static final List<Vec3> AXES =
            List.of(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3(0, -2, 0));

    private static Solid rotated(Solid solid, Vec3 pivot, Vec3 axis, double degrees) {
        return SolidTransform.rotated(solid, pivot, axis, degrees).result().orElseThrow();
    }

    private static Solid scaled(Solid solid, Vec3 pivot, Vec3 factors) {
        return SolidTransform.scaled(solid, pivot, factors).result().orElseThrow();
    }

    @Test
    void movedThereAndBackIsTheSameToTheLastBit() {
        RandomSolids solids = new RandomSolids(10);
        for (int i = 0; i < CASES; i++) {
            Solid solid = solids.next();
            Vec3 by = solids.point(1000);
            Solid moved = SolidTransform.moved(solid, by);
            assertEquals(solid.getClass(), moved.getClass());
            assertEquals(solid, SolidTransform.moved(moved, by.negated()));
            Aabb expected = bounds(solid).moved(by);
            assertEquals(expected.minX(), bounds(moved).minX(), 1e-9);
            assertEquals(expected.maxZ(), bounds(moved).maxZ(), 1e-9);
            assertEquals(FaceLooks.of(solid), FaceLooks.of(moved));
        }
    }

    @Test
    void decimalsStayDecimals() {
        Solid box = SolidShape.box("b", new Vec3(0, 0, 0), new Vec3(0.2, 0.2, 0.2));
        Solid.Box moved = (Solid.Box) SolidTransform.moved(box, new Vec3(0.2, 0.7, 0));
        assertEquals(new Vec3(0.3, 0.8, 0.1), moved.centre());
    }

    @Test
    void fourQuarterTurnsGiveTheSameRecord() {
        RandomSolids solids = new RandomSolids(11);
        for (int i = 0; i < CASES; i++) {
            Solid solid = solids.next();
            Vec3 pivot = solids.point(20);
            Vec3 axis = AXES.get(i % AXES.size());
            Solid turned = solid;
            for (int quarter = 0; quarter < 4; quarter++) {
                turned = rotated(turned, pivot, axis, 90);
                assertEquals(volume(solid), volume(turned), 1e-9 * volume(solid));
            }
            assertEquals(solid, turned, "around " + axis);
            assertEquals(solid, rotated(rotated(solid, pivot, axis, -270), pivot, axis, 270));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {90, 180, 270, 30, -45, 17.3})
    void rotatedSolidsHoldTheRotatedPointsWithTheSameFaces(double degrees) {
        RandomSolids solids = new RandomSolids(12);
        for (int i = 0; i < 20; i++) {
            Solid solid = solids.next();
            Vec3 pivot = solids.point(3);
            Vec3 axis = i % 2 == 0 ? AXES.get(i % 3) : solids.direction();
            Solid turned = rotated(solid, pivot, axis, degrees);
            assertAccepted(List.of(turned));
            Brush before = Brush.of(solid);
            Brush after = Brush.of(turned);
            for (int at = 0; at < before.faces().size(); at++) {
                Vec3 middle = average(before.faces().get(at).polygon());
                Vec3 there = turn(middle, pivot, axis, Math.toRadians(degrees));
                Brush.BrushFace face = after.faces().stream()
                        .min((a, b) -> Double.compare(
                                Math.abs(a.plane().signedDistance(there)),
                                Math.abs(b.plane().signedDistance(there))))
                        .orElseThrow();
                assertEquals(0, depth(after, there), 1e-9);
                assertEquals(before.faces().get(at).material(), face.material());
                assertEquals(before.faces().get(at).portalable(), face.portalable());
            }
        }
    }

    private static Vec3 average(List<Vec3> ring) {
        Vec3 sum = Vec3.ZERO;
        for (Vec3 p : ring) {
            sum = sum.plus(p);
        }
        return sum.scaled(1.0 / ring.size());
    }

    /** Rotates by the formula of Rodrigues. */
    private static Vec3 turn(Vec3 p, Vec3 pivot, Vec3 axis, double radians) {
        Vec3 k = axis.scaled(1 / axis.length());
        Vec3 v = p.minus(pivot);
        Vec3 turned = v.scaled(Math.cos(radians))
                .plus(k.cross(v).scaled(Math.sin(radians)))
                .plus(k.scaled(k.dot(v) * (1 - Math.cos(radians))));
        return pivot.plus(turned);
    }

    @ParameterizedTest
    @CsvSource({"PLUS_X, 270, MINUS_X", "PLUS_X, 90, ", "MINUS_X, 90, PLUS_X", "PLUS_Z, 90, ", "PLUS_X, 180, "})
    void aWedgeTurnedAboutZIsAWedgeWhereItStandsOnItsBase(BoxFace rising, double degrees, BoxFace after) {
        Solid wedge =
                new Solid.Wedge("w", null, false, TextureMapping.WORLD, Vec3.ZERO, new Vec3(4, 2, 3), rising, Map.of());
        Solid turned = rotated(wedge, Vec3.ZERO, new Vec3(0, 0, 1), degrees);
        if (after == null) {
            assertInstanceOf(Solid.Planes.class, turned);
        } else {
            assertEquals(after, assertInstanceOf(Solid.Wedge.class, turned).rising());
            assertEquals(new Vec3(2, 4, 3), ((Solid.Wedge) turned).size());
        }
    }

    @Test
    void aBoxTurnedByTwoEighthsIsABoxAgain() {
        Solid box = SolidShape.box("b", Vec3.ZERO, new Vec3(2, 1, 4));
        Solid once = rotated(box, Vec3.ZERO, new Vec3(0, 1, 0), 45);
        assertInstanceOf(Solid.Planes.class, once);
        Solid twice = rotated(once, Vec3.ZERO, new Vec3(0, 1, 0), 45);
        assertEquals(rotated(box, Vec3.ZERO, new Vec3(0, 1, 0), 90), twice);
    }

    @ParameterizedTest
    @CsvSource({"2, 2, 2", "0.5, 3, 0.5", "-1, 1, 1", "1, -1, 1", "1, 1, -1", "-2, 0.5, 3", "-1, -1, -1"})
    void scalingMultipliesVolumeAndScalesPoints(double x, double y, double z) {
        RandomSolids solids = new RandomSolids(13);
        for (int i = 0; i < 25; i++) {
            Solid solid = solids.next();
            Vec3 pivot = solids.point(3);
            Solid result = scaled(solid, pivot, new Vec3(x, y, z));
            assertEquals(volume(solid) * Math.abs(x * y * z), volume(result), 1e-9 * volume(result), solid.toString());
            Brush after = Brush.of(result);
            for (Brush.BrushFace face : Brush.of(solid).faces()) {
                Vec3 v = average(face.polygon()).minus(pivot);
                Vec3 there = pivot.plus(new Vec3(v.x() * x, v.y() * y, v.z() * z));
                assertEquals(0, depth(after, there), 1e-9);
                Brush.BrushFace now = after.faces().stream()
                        .filter(f -> Math.abs(f.plane().signedDistance(there)) < 1e-7)
                        .findFirst()
                        .orElseThrow();
                assertEquals(face.material(), now.material());
            }
            assertAccepted(List.of(result));
            Solid back = scaled(result, pivot, new Vec3(1 / x, 1 / y, 1 / z));
            assertEquals(volume(solid), volume(back), 1e-9 * volume(solid));
        }
    }

    @Test
    void boxesWedgesAndPrismsStayWhatTheyAreWhereTheyCan() {
        RandomSolids solids = new RandomSolids(14);
        Vec3 stretched = new Vec3(2, 3, -0.5);
        assertInstanceOf(Solid.Box.class, scaled(solids.box(), Vec3.ZERO, stretched));
        assertInstanceOf(Solid.Wedge.class, scaled(solids.wedge(), Vec3.ZERO, stretched));
        assertInstanceOf(Solid.Prism.class, scaled(solids.prism(), Vec3.ZERO, new Vec3(2, 3, -2)));
        assertInstanceOf(Solid.Planes.class, scaled(solids.wedge(), Vec3.ZERO, new Vec3(1, -1, 1)));
        Solid.Prism odd = new Solid.Prism("p", null, false, TextureMapping.WORLD, Vec3.ZERO, 1, 1, 5, Map.of());
        assertInstanceOf(Solid.Planes.class, scaled(odd, Vec3.ZERO, new Vec3(-1, 1, 1)));
        assertEquals(odd, scaled(scaled(odd, Vec3.ZERO, new Vec3(-1, 1, 1)), Vec3.ZERO, new Vec3(-1, 1, 1)));
    }

    @Test
    void aScaleToNothingIsRefused() {
        Solid box = SolidShape.box("b", Vec3.ZERO, new Vec3(1, 1, 1));
        assertEquals(
                BrushText.FLAT,
                SolidTransform.scaled(box, Vec3.ZERO, new Vec3(1, 0, 1))
                        .refusal()
                        .orElseThrow());
        assertEquals(
                BrushText.TOO_THIN,
                SolidTransform.scaled(box, Vec3.ZERO, new Vec3(1, 1e-5, 1))
                        .refusal()
                        .orElseThrow());
        assertEquals(
                BrushText.OUT_OF_WORLD,
                SolidTransform.scaled(box, Vec3.ZERO, new Vec3(1, 1e8, 1))
                        .refusal()
                        .orElseThrow());
    }
}
