package nephele.engine.level.placed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.ModelPlacement.TransformStep.Rotate;
import nephele.engine.level.ModelPlacement.TransformStep.Scale;
import nephele.engine.level.ModelPlacement.TransformStep.Translate;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Aabb;
import nephele.engine.math.Chance;
import nephele.engine.math.Vec3;
import nephele.engine.model.bound.Bound;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A sphere touches the bounds of models where the closed form says. */
class ModelBoundsTest {
    private static final Vec3 AT = new Vec3(40, 1, -7);
    private static final double RADIUS = 0.5;
    private static final double HALF = Math.sqrt(0.5);

    /** A cube of edge 2 that is turned by 45° about y. */
    private static ModelBounds cube() {
        return bounds(
                new TestLevel().model("box_1_1.3d", null, new Translate(AT), turn(), new Scale(new Vec3(2, 2, 2))));
    }

    private static Rotate turn() {
        return new Rotate(new Vec3(0, 1, 0), 45);
    }

    private static ModelBounds bounds(TestLevel level) {
        return ModelBounds.of(PlacedModels.of(level.level(), NoFiles.AT_ALL));
    }

    /** Towards a side of the cube (a diagonal of the world) and along x, towards an edge. */
    @ParameterizedTest
    @CsvSource({
        "SPHERE, 1.7320508, 1.7320508",
        "BOX, 2, 1.4142136",
        "ORIENTED_BOX, 1, 1.4142136",
        "TREE, 1, 1.4142136",
        "TRIANGLES, 1, 1.4142136"
    })
    void contactBeginsAtTheDistanceOfTheClosedForm(Bound kind, double diagonal, double alongX) {
        ModelBounds cube = cube();
        assertBegins(cube, kind, new Vec3(HALF, 0, HALF), diagonal + RADIUS);
        assertBegins(cube, kind, new Vec3(-HALF, 0, HALF), diagonal + RADIUS);
        assertBegins(cube, kind, new Vec3(1, 0, 0), alongX + RADIUS);
    }

    private static void assertBegins(ModelBounds bounds, Bound kind, Vec3 direction, double metres) {
        assertFalse(bounds.touch(kind, AT.addScaled(metres + 1e-5, direction), RADIUS), kind + " outside");
        assertTrue(bounds.touch(kind, AT.addScaled(metres - 1e-5, direction), RADIUS), kind + " inside");
    }

    @Test
    void surfacesAreNotTouchedFromTheMiddle() {
        for (Bound kind : Bound.values()) {
            assertEquals(kind.compareTo(Bound.TREE) < 0, cube().touch(kind, AT, RADIUS), kind.name());
        }
    }

    /** Uneven scales outside of a rotation shear a model: its box still contains all corners. */
    @Test
    void aShearedModelIsInItsBounds() {
        Scale uneven = new Scale(new Vec3(3, 1, 0.5));
        var level = new TestLevel().model("box_1_1.3d", null, new Translate(AT), uneven, turn());
        PlacedModels models = PlacedModels.of(level.level(), NoFiles.AT_ALL);
        ModelBounds bounds = ModelBounds.of(models);
        double[] corners = models.all().get(0).triangles().positions();
        for (int i = 0; i < corners.length; i += 3) {
            for (Bound kind : Bound.values()) {
                assertTrue(bounds.touch(kind, new Vec3(corners[i], corners[i + 1], corners[i + 2]), 1e-5), kind.name());
            }
        }
    }

    @Test
    void nothingIsTouchedWithoutModels() {
        for (Bound kind : Bound.values()) {
            assertFalse(bounds(new TestLevel()).touch(kind, Vec3.ZERO, 100));
            assertTrue(bounds(new TestLevel()).outlines(kind).isEmpty());
        }
    }

    /** The lines of a box end at its corners, those of a sphere at its radius. */
    @Test
    void outlinesLieOnTheBounds() {
        Aabb box = Aabb.of(cube().outlines(Bound.BOX));
        assertEquals(2 * Math.sqrt(2), box.maxX() - box.minX(), 1e-6);
        assertEquals(2, box.maxY() - box.minY(), 1e-6);
        for (Vec3 end : cube().outlines(Bound.SPHERE)) {
            assertEquals(Math.sqrt(3), end.minus(AT).length(), 1e-5);
        }
        for (Bound kind : new Bound[] {Bound.ORIENTED_BOX, Bound.TREE, Bound.TRIANGLES}) {
            for (Vec3 end : cube().outlines(kind)) {
                assertEquals(Math.sqrt(3), end.minus(AT).length(), 1e-5, kind.name());
            }
        }
    }

    /** No point of a dense grid on the triangle is nearer, and one is nearly as near. */
    @Test
    void theDistanceToATriangleIsThatOfItsNearestPoint() {
        for (int i = 0; i < 200; i++) {
            long dice = Chance.dice(5, i);
            Vec3[] triangle = {point(dice, 0), point(dice, 3), point(dice, 6)};
            Vec3 place = point(dice, 9).scaled(2);
            double nearest = Double.POSITIVE_INFINITY;
            for (int a = 0; a <= 100; a++) {
                for (int b = 0; a + b <= 100; b++) {
                    Vec3 on = triangle[0]
                            .scaled(a / 100.0)
                            .addScaled(b / 100.0, triangle[1])
                            .addScaled((100 - a - b) / 100.0, triangle[2]);
                    nearest = Math.min(nearest, on.minus(place).length());
                }
            }
            double distance = Bound.distance(triangle, place);
            assertTrue(distance <= nearest + 1e-12 && distance > nearest - 0.03, distance + " " + nearest);
        }
    }

    private static Vec3 point(long dice, int purpose) {
        return new Vec3(
                Chance.unit(dice, purpose) - 0.5,
                Chance.unit(dice, purpose + 1) - 0.5,
                Chance.unit(dice, purpose + 2) - 0.5);
    }
}
