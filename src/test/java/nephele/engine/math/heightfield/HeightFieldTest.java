package nephele.engine.math.heightfield;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.function.ToDoubleBiFunction;
import java.util.stream.Stream;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class HeightFieldTest {
    /** Returns the field of a plane; every sample differs from its neighbours. */
    private static HeightField slope(Vec3 origin, int columns, int rows) {
        return HeightField.of(origin, 0.5, columns, rows, (column, row) -> 0.25 * column - 0.125 * row);
    }

    private static HeightField flat(int columns, int rows) {
        return HeightField.of(Vec3.ZERO, 1, columns, rows, (column, row) -> 2);
    }

    private static HeightField spikes() {
        return HeightField.of(Vec3.ZERO, 1, 33, 33, (column, row) -> (column * 7 + row * 5) % 11 == 0 ? 1000 : 0);
    }

    private static double entry(HeightField field, Ray ray) {
        RayHit hit = new RayHit();
        boolean isMet = field.nearest(ray, Double.POSITIVE_INFINITY, (r, t, most) -> field.entry(r, t), hit);
        return isMet ? hit.distance() : Double.POSITIVE_INFINITY;
    }

    private static double either(HeightField field, Ray ray) {
        RayHit hit = new RayHit();
        boolean isMet = field.nearest(ray, Double.POSITIVE_INFINITY, (r, t, most) -> field.intersection(r, t), hit);
        return isMet ? hit.distance() : Double.POSITIVE_INFINITY;
    }

    private static Ray down(double x, double y, double z) {
        return new Ray(x, y, z, 0, -1, 0);
    }

    @Test
    void trianglesLieCounterClockwiseOnBothSidesOfTheDiagonalToTheGreatestCorner() {
        HeightField field = slope(new Vec3(10, 20, 30), 3, 4);
        assertEquals(12, field.triangles());
        int inSecondCellOfThirdRow = 2 * (2 * 2 + 1);
        Vec3 least = new Vec3(10.5, 20, 31);
        Vec3 greatest = new Vec3(11, 20.125, 31.5);
        assertEquals(least, field.corner(inSecondCellOfThirdRow, 0));
        assertEquals(new Vec3(10.5, 19.875, 31.5), field.corner(inSecondCellOfThirdRow, 1));
        assertEquals(greatest, field.corner(inSecondCellOfThirdRow, 2));
        assertEquals(least, field.corner(inSecondCellOfThirdRow + 1, 0));
        assertEquals(greatest, field.corner(inSecondCellOfThirdRow + 1, 1));
        assertEquals(new Vec3(11, 20.25, 31), field.corner(inSecondCellOfThirdRow + 1, 2));
        for (int triangle = 0; triangle < field.triangles(); triangle++) {
            Vec3 normal = field.normal(triangle);
            assertEquals(0, normal.x() + 0.5 * normal.y(), 1e-15);
            assertEquals(0, normal.z() - 0.25 * normal.y(), 1e-15);
            assertTrue(normal.y() > 0);
        }
    }

    @ParameterizedTest
    @CsvSource({"2, 2", "2, 3", "5, 2", "6, 5", "4, 9", "2, 40", "40, 2", "17, 31"})
    void everyTriangleIsFoundByItsOwnBoxAndAllByTheWholeOne(int columns, int rows) {
        HeightField field = slope(Vec3.ZERO, columns, rows);
        TreeSet<Integer> all = new TreeSet<>();
        field.passing(field.bounds()::overlaps, all::add);
        assertEquals(field.triangles(), all.size());
        for (int triangle = 0; triangle < field.triangles(); triangle++) {
            Aabb box = box(field, triangle);
            TreeSet<Integer> expected = new TreeSet<>();
            for (int other = 0; other < field.triangles(); other++) {
                if (box.overlaps(box(field, other))) {
                    expected.add(other);
                }
            }
            TreeSet<Integer> found = new TreeSet<>();
            field.passing(box::overlaps, found::add);
            assertEquals(expected, found);
        }
    }

    private static Aabb box(HeightField field, int triangle) {
        return Aabb.of(
                java.util.List.of(field.corner(triangle, 0), field.corner(triangle, 1), field.corner(triangle, 2)));
    }

    /** There is no gap on corners, on edges along x and z and on the diagonal, including the field's border. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e5, -1e5, 9e6})
    void aRayDownMeetsCornersEdgesAndDiagonals(double out) {
        HeightField field = slope(new Vec3(out, out / 100, -out), 9, 7);
        double rounding = 1e-15 * (1 + Math.abs(out)) * 4;
        for (int column = 0; column <= 16; column++) {
            for (int row = 0; row <= 12; row++) {
                double x = out + 0.25 * column;
                double z = -out + 0.25 * row;
                double height = out / 100 + 0.5 * (x - out) - 0.25 * (z + out);
                assertEquals(50, entry(field, down(x, height + 50, z)), 50 * rounding + 1e-9, column + " " + row);
            }
        }
    }

    @Test
    void aRayAlongAnEdgeOrTheDiagonalMeetsWhatRisesAcrossIt() {
        HeightField field = HeightField.of(Vec3.ZERO, 1, 9, 9, (column, row) -> column == 6 && row == 6 ? 3 : 1);
        double onRidge = 5.5;
        assertEquals(onRidge, entry(field, new Ray(0, 2, 6, 1, 0, 0)));
        assertEquals(onRidge, entry(field, new Ray(6, 2, 0, 0, 0, 1)));
        assertEquals(onRidge, entry(field, new Ray(0, 2, 0, 1, 0, 1)));
        assertEquals(Double.POSITIVE_INFINITY, entry(field, new Ray(0, 2, 4, 1, 0, 0)));
    }

    @Test
    void aRayInThePlaneOfFlatGroundMeetsNothingAndALittleBelowItNeither() {
        HeightField field = flat(9, 9);
        for (Vec3 way : new Vec3[] {new Vec3(1, 0, 0), new Vec3(0, 0, 1), new Vec3(1, 0, 1), new Vec3(1, 0, 0.3)}) {
            assertEquals(Double.POSITIVE_INFINITY, entry(field, Ray.of(new Vec3(-1, 2, 0), way)));
            assertEquals(Double.POSITIVE_INFINITY, entry(field, Ray.of(new Vec3(-1, 1.999, 0), way)));
        }
    }

    /**
     * The ray is parallel to both triangles, half a metre beside them; all signed volumes are rounding, here of one
     * sign.
     */
    @Test
    void aRayAlongTheGroundMeetsNoTriangleThatItDoesNotReach() {
        int[] heights = {1, 0, 0, -1};
        HeightField field = HeightField.of(new Vec3(5, 0, 44), 1, 2, 2, (column, row) -> heights[2 * row + column]);
        Ray ray = new Ray(29.851247383779018, -1.4951510549045568, 21.64390367112554, -1, 0, 1);
        assertEquals(Double.POSITIVE_INFINITY, field.intersection(ray, 0));
        assertEquals(Double.POSITIVE_INFINITY, field.intersection(ray, 1));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e-6, 1e-9, 1e-12})
    void aGrazingRayMeetsFlatGroundWhereItGoesDown(double drop) {
        assertEquals(5, entry(flat(9, 9), new Ray(-1, 2 + 5 * drop, 4.3, 1, -drop, 0)), 1e-15 / drop + 1e-9);
    }

    @Test
    void fromBelowOnlyTheBackIsMet() {
        for (HeightField field : new HeightField[] {flat(9, 9), slope(Vec3.ZERO, 9, 9)}) {
            Ray up = new Ray(3.1, -50, 2.2, 0, 1, 0);
            assertEquals(Double.POSITIVE_INFINITY, entry(field, up));
            assertTrue(either(field, up) < 60);
        }
        assertEquals(Double.POSITIVE_INFINITY, entry(flat(9, 9), down(3, 1.99, 3)));
    }

    @ParameterizedTest
    @CsvSource({"2, 0", "1.9999999999, 0", "2.5, 0.5"})
    void aRayThatStartsOnTheGroundAndGoesDownMeetsItAtOnce(double y, double expected) {
        assertEquals(expected, entry(flat(9, 9), down(3.3, y, 4.7)), 1e-15);
    }

    @Test
    void noRayPassesBetweenSpikes() {
        HeightField field = spikes();
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 2000; i++) {
            double x = random.nextDouble(0.5, 31.5);
            double z = random.nextDouble(0.5, 31.5);
            Ray ray = new Ray(x, 2000, z, random.nextDouble(-1e-4, 1e-4), -1, random.nextDouble(-1e-4, 1e-4));
            assertTrue(entry(field, ray) < 2000.001, "ray " + i);
        }
    }

    @Test
    void aRayBesideTheFieldOrWithoutADirectionMeetsNothing() {
        HeightField field = flat(2, 2);
        assertEquals(Double.POSITIVE_INFINITY, entry(field, down(1.001, 5, 0.5)));
        assertEquals(Double.POSITIVE_INFINITY, entry(field, down(0.5, 5, -0.001)));
        assertEquals(Double.POSITIVE_INFINITY, entry(field, new Ray(0.5, 5, 0.5, 0, 0, 0)));
        assertEquals(Double.POSITIVE_INFINITY, entry(field, new Ray(0.5, Double.NaN, 0.5, 0, -1, 0)));
        assertEquals(Double.POSITIVE_INFINITY, entry(field, new Ray(1e300, 1e300, 1e300, -1, -1, -1)));
    }

    static Stream<Arguments> refused() {
        return Stream.of(
                Arguments.of(1, 5, 1.0, 0.0, "2 to 8193 samples along each side, not 1 × 5"),
                Arguments.of(8194, 2, 1.0, 0.0, "not 8194 × 2"),
                Arguments.of(3, 3, 0.0, 0.0, "cells are 0.001 m to 1.0E7 m wide, not 0.0 m"),
                Arguments.of(3, 3, Double.NaN, 0.0, "not NaN m"),
                Arguments.of(3, 3, 1.0, Double.NaN, "begins at x NaN m, y"),
                Arguments.of(8193, 2, 2000.0, 0.0, "no farther than 1.0E7 m"));
    }

    @ParameterizedTest
    @MethodSource("refused")
    void gridsThatCannotBeAreRefused(int columns, int rows, double cell, double x, String because) {
        IllegalArgumentException told = assertThrows(
                IllegalArgumentException.class,
                () -> HeightField.of(new Vec3(x, 0, 0), cell, columns, rows, (column, row) -> 0));
        assertTrue(told.getMessage().contains(because), told.getMessage());
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1.1e7})
    void heightsThatAreNoPlacesAreRefusedWithTheirSample(double bad) {
        ToDoubleBiFunction<Integer, Integer> heights = (column, row) -> column == 2 && row == 1 ? bad : 0;
        IllegalArgumentException told = assertThrows(
                IllegalArgumentException.class, () -> HeightField.of(Vec3.ZERO, 1, 3, 3, heights::applyAsDouble));
        assertTrue(told.getMessage().startsWith("the height at column 2, row 1 is " + bad), told.getMessage());
    }
}
