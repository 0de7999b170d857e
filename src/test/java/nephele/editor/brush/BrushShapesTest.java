package nephele.editor.brush;

import static nephele.editor.brush.SolidShape.assertAccepted;
import static nephele.editor.brush.SolidShape.bounds;
import static nephele.editor.brush.SolidShape.depth;
import static nephele.editor.brush.SolidShape.volume;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import java.util.stream.Stream;
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
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class BrushShapesTest {
    private static final Aabb BOX = new Aabb(-1, 2, 3, 5, 5, 7);
    private static final BrushStyle STYLE = new BrushStyle("tile", true, TextureMapping.FACE);

    private static BrushEdit<List<Solid>> drawn(Aabb box, ShapeOptions options) {
        AtomicInteger next = new AtomicInteger();
        Supplier<String> ids = () -> "new " + next.incrementAndGet();
        return BrushShapes.drawn(box, options, STYLE, ids);
    }

    private static List<Solid> solids(Aabb box, ShapeOptions options) {
        return drawn(box, options).result().orElseThrow();
    }

    static Stream<ShapeOptions> options() {
        return Stream.of(
                new ShapeOptions.Box(),
                new ShapeOptions.Wedge(null),
                new ShapeOptions.Wedge(BoxFace.MINUS_Z),
                new ShapeOptions.Stairs(BoxFace.MINUS_X, 7),
                new ShapeOptions.Arch(9, 0.5),
                new ShapeOptions.Cylinder(12),
                new ShapeOptions.Cylinder(7),
                new ShapeOptions.Room(0.25));
    }

    @ParameterizedTest
    @MethodSource("options")
    void everyShapeStaysInItsBoxWithTheStyleAndDoesNotOverlapItself(ShapeOptions options) {
        List<Solid> solids = solids(BOX, options);
        assertAccepted(solids);
        assertEquals(solids.size(), solids.stream().map(Solid::id).distinct().count());
        for (Solid solid : solids) {
            assertEquals(STYLE, new BrushStyle(solid.material(), solid.portalable(), solid.textureMapping()));
            assertTrue(Brush.of(solid).shape().vertices().stream()
                    .allMatch(v -> depth(Brush.of(SolidShape.box("b", low(BOX), high(BOX))), v) < 1e-9));
        }
        List<Brush> parts = solids.stream().map(Brush::of).toList();
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 300; i++) {
            Vec3 p = SolidShape.pointIn(BOX, random);
            assertTrue(parts.stream().filter(part -> depth(part, p) < -1e-9).count() <= 1, p.toString());
        }
    }

    private static Vec3 low(Aabb box) {
        return new Vec3(box.minX(), box.minY(), box.minZ());
    }

    private static Vec3 high(Aabb box) {
        return new Vec3(box.maxX(), box.maxY(), box.maxZ());
    }

    @Test
    void aWedgeRisesAlongTheLongerSideUnlessGiven() {
        assertEquals(
                BoxFace.PLUS_X,
                ((Solid.Wedge) solids(BOX, new ShapeOptions.Wedge(null)).get(0)).rising());
        assertEquals(
                BoxFace.PLUS_Z,
                ((Solid.Wedge) solids(new Aabb(0, 0, 0, 1, 1, 2), new ShapeOptions.Wedge(null))
                                .get(0))
                        .rising());
        assertEquals(
                BoxFace.MINUS_Z,
                ((Solid.Wedge) solids(BOX, new ShapeOptions.Wedge(BoxFace.MINUS_Z))
                                .get(0))
                        .rising());
    }

    @ParameterizedTest
    @CsvSource({"PLUS_X", "MINUS_X", "PLUS_Z", "MINUS_Z"})
    void stairsRiseStepByStepTowardsTheirSide(BoxFace rising) {
        List<Solid> steps = solids(BOX, new ShapeOptions.Stairs(rising, 6));
        assertEquals(6, steps.size());
        assertEquals(6 * 3 * 4 * (7 / 12.0), volume(steps), 1e-9);
        for (int i = 0; i < 6; i++) {
            Solid.Box step = assertInstanceOf(Solid.Box.class, steps.get(i));
            assertEquals(2 + 0.5 * (i + 1), bounds(step).maxY(), 1e-12);
            assertEquals(2, bounds(step).minY(), 1e-12);
        }
        Vec3 way = ((Solid.Box) steps.get(5)).centre().minus(((Solid.Box) steps.get(0)).centre());
        assertTrue(way.dot(rising.normal()) > 0);
    }

    /** The section of an arch has the area between two polygons inscribed in ellipses. */
    @ParameterizedTest
    @CsvSource({"2, 0.25", "3, 1", "8, 0.5", "64, 0.125", "5, 2.5"})
    void anArchHasNoGapAndLeavesTheOpeningFree(int segments, double thickness) {
        for (Aabb box : List.of(BOX, new Aabb(0, 0, 0, 1, 3, 6))) {
            List<Solid> blocks = solids(box, new ShapeOptions.Arch(segments, thickness));
            assertEquals(segments, blocks.size());
            double wide = Math.max(box.maxX() - box.minX(), box.maxZ() - box.minZ()) / 2;
            double deep = Math.min(box.maxX() - box.minX(), box.maxZ() - box.minZ());
            double high = box.maxY() - box.minY();
            double section = (wide * high - (wide - thickness) * (high - thickness))
                    * segments
                    * Math.sin(Math.PI / segments)
                    / 2;
            assertEquals(section * deep, volume(blocks), 1e-9 * section * deep);
            assertAccepted(blocks);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 8, 16, 60})
    void aCylinderInASquareIsAPrismThatTouchesItsSides(int sides) {
        Aabb square = new Aabb(1, 0, 1, 3, 4, 3);
        Solid solid = solids(square, new ShapeOptions.Cylinder(sides)).get(0);
        assertEquals(sides, assertInstanceOf(Solid.Prism.class, solid).sides());
        assertEquals(3, bounds(solid).maxX(), 1e-12);
        assertEquals(1, bounds(solid).minZ(), 1e-12);
        Solid oval = solids(BOX, new ShapeOptions.Cylinder(sides)).get(0);
        assertEquals(BOX.minX(), bounds(oval).minX(), 1e-9);
        assertEquals(BOX.maxZ(), bounds(oval).maxZ(), 1e-9);
    }

    @Test
    void aRoomIsItsWalls() {
        List<Solid> walls = solids(BOX, new ShapeOptions.Room(0.5));
        assertEquals(6, walls.size());
        walls.forEach(wall -> assertInstanceOf(Solid.Box.class, wall));
        assertEquals(6 * 3 * 4 - 5 * 2 * 3, volume(walls), 1e-9);
    }

    @Test
    void badNumbersAreRefused() {
        Aabb flat = new Aabb(0, 0, 0, 1, 0, 1);
        assertEquals(
                BrushText.TOO_THIN,
                drawn(flat, new ShapeOptions.Box()).refusal().orElseThrow());
        assertEquals(
                BrushText.BAD_OPTIONS,
                drawn(BOX, new ShapeOptions.Stairs(null, 0)).refusal().orElseThrow());
        assertEquals(
                BrushText.TOO_THIN,
                drawn(new Aabb(0, 0, 0, 1, 0.01, 1), new ShapeOptions.Stairs(null, 1000))
                        .refusal()
                        .orElseThrow());
        assertEquals(
                BrushText.BAD_OPTIONS,
                drawn(BOX, new ShapeOptions.Arch(5, 3)).refusal().orElseThrow());
        assertEquals(
                BrushText.BAD_OPTIONS,
                drawn(BOX, new ShapeOptions.Cylinder(2)).refusal().orElseThrow());
        assertEquals(
                BrushText.WALL_TOO_THICK,
                drawn(BOX, new ShapeOptions.Room(1.5)).refusal().orElseThrow());
    }
}
