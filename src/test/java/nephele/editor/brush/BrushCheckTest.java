package nephele.editor.brush;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

@Execution(ExecutionMode.CONCURRENT)
class BrushCheckTest {
    private static Solid box(Vec3 centre, Vec3 size) {
        return new Solid.Box("b", null, false, TextureMapping.WORLD, centre, size, Map.of());
    }

    private static Solid wedge(BoxFace rising, Vec3 size) {
        return new Solid.Wedge("w", null, false, TextureMapping.WORLD, Vec3.ZERO, size, rising, Map.of());
    }

    private static Solid slab(double thickness) {
        List<PlaneFace> planes = Stream.of(BoxFace.values())
                .map(side -> new PlaneFace(side.normal(), side == BoxFace.PLUS_Y ? thickness - 1 : 1, null, null, null))
                .toList();
        return new Solid.Planes("s", null, false, TextureMapping.WORLD, planes);
    }

    static Stream<Arguments> degenerate() {
        Solid open = new Solid.Planes(
                "o",
                null,
                false,
                TextureMapping.WORLD,
                ((Solid.Planes) slab(1)).planes().subList(0, 5));
        Solid shortNormal = new Solid.Planes(
                "n",
                null,
                false,
                TextureMapping.WORLD,
                ((Solid.Planes) slab(1))
                        .planes().stream()
                                .map(face -> new PlaneFace(
                                        face.normal().scaled(1e-10), face.distanceMetres(), null, null, null))
                                .toList());
        return Stream.of(
                Arguments.of(box(Vec3.ZERO, new Vec3(1, 5e-5, 1)), BrushText.TOO_THIN),
                Arguments.of(box(Vec3.ZERO, new Vec3(1, 0, 1)), BrushText.NOT_SOLID),
                Arguments.of(box(Vec3.ZERO, new Vec3(1, Double.NaN, 1)), BrushText.NOT_SOLID),
                Arguments.of(box(new Vec3(9.9999999e6, 0, 0), new Vec3(1, 1, 1)), BrushText.OUT_OF_WORLD),
                Arguments.of(box(new Vec3(Double.NaN, 0, 0), new Vec3(1, 1, 1)), BrushText.OUT_OF_WORLD),
                Arguments.of(wedge(BoxFace.PLUS_Y, new Vec3(1, 1, 1)), BrushText.NOT_SOLID),
                Arguments.of(wedge(BoxFace.PLUS_X, new Vec3(1, 1, 5e-5)), BrushText.TOO_THIN),
                Arguments.of(
                        new Solid.Prism("p", null, false, TextureMapping.WORLD, Vec3.ZERO, 1, 5e-5, 8, Map.of()),
                        BrushText.TOO_THIN),
                Arguments.of(slab(5e-5), BrushText.TOO_THIN),
                Arguments.of(slab(-1), BrushText.NOT_SOLID),
                Arguments.of(open, BrushText.NOT_SOLID),
                Arguments.of(shortNormal, BrushText.NOT_SOLID));
    }

    @ParameterizedTest
    @MethodSource("degenerate")
    void aDegenerateSolidHasAReason(Solid solid, BrushText why) {
        assertEquals(Optional.of(why), BrushCheck.refusal(solid));
    }

    @Test
    void validSolidsHaveNone() {
        RandomSolids solids = new RandomSolids(80);
        for (int i = 0; i < 100; i++) {
            assertEquals(Optional.empty(), BrushCheck.refusal(solids.next()));
        }
        assertEquals(Optional.empty(), BrushCheck.refusal(box(Vec3.ZERO, new Vec3(1e-4, 1e-4, 1e-4))));
        assertEquals(Optional.empty(), BrushCheck.refusal(slab(1e-3)));
    }
}
