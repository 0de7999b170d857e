package nephele.editor.brush;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Solid;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.rule.LevelRules;

/** Queries of tests on the shapes of solids. */
final class SolidShape {
    private SolidShape() {}

    static double volume(Solid solid) {
        return Brush.of(solid).shape().volumeCubicMetres();
    }

    static double volume(List<Solid> solids) {
        return solids.stream().mapToDouble(SolidShape::volume).sum();
    }

    static Aabb bounds(Solid solid) {
        return Brush.of(solid).shape().bounds();
    }

    /** Returns the greatest signed distance from a plane: negative inside. */
    static double depth(Brush brush, Vec3 point) {
        double depth = Double.NEGATIVE_INFINITY;
        for (Brush.BrushFace face : brush.faces()) {
            depth = Math.max(depth, face.plane().signedDistance(point));
        }
        return depth;
    }

    static Vec3 pointIn(Aabb box, SplittableRandom random) {
        return new Vec3(
                box.minX() + random.nextDouble() * (box.maxX() - box.minX()),
                box.minY() + random.nextDouble() * (box.maxY() - box.minY()),
                box.minZ() + random.nextDouble() * (box.maxZ() - box.minZ()));
    }

    static Solid.Box box(String id, Vec3 from, Vec3 to) {
        Aabb box = Aabb.of(List.of(from, to));
        return new Solid.Box(
                id, "brick", false, TextureMapping.WORLD, ExactNumber.centre(box), ExactNumber.size(box), Map.of());
    }

    /** Returns the face of a solid whose normal is nearest to a direction. */
    static Brush.BrushFace towards(Solid solid, Vec3 direction) {
        return Brush.of(solid).faces().get(indexTowards(solid, direction));
    }

    static int indexTowards(Solid solid, Vec3 direction) {
        List<Brush.BrushFace> faces = Brush.of(solid).faces();
        int best = 0;
        for (int i = 1; i < faces.size(); i++) {
            Plane plane = faces.get(i).plane();
            best = plane.normal().dot(direction)
                            > faces.get(best).plane().normal().dot(direction)
                    ? i
                    : best;
        }
        return best;
    }

    /** Checks that a level of these solids breaks no rule and is read as it was written. */
    static void assertAccepted(List<Solid> solids) {
        List<Solid> named = new ArrayList<>();
        for (Solid solid : solids) {
            assertEquals(Optional.empty(), BrushCheck.refusal(solid));
            named.add(solid.withId("solid " + named.size()));
        }
        TestLevel level = new TestLevel();
        for (String material : List.of("brick", "tile", "metal")) {
            level.material(material, TestLevel.grey(0.5));
        }
        Level with = level.level();
        with = with.with(with.materials(), named);
        List<Problem> problems = LevelRules.checkRecords(with).stream()
                .filter(problem -> problem.path().startsWith("solids"))
                .toList();
        assertEquals(List.of(), problems);
        try {
            byte[] text = LevelJson.write(with).getBytes(StandardCharsets.UTF_8);
            assertEquals(with.solids(), LevelJson.read("test", text).solids());
        } catch (LevelFormatException refused) {
            throw new AssertionError(refused);
        }
    }
}
