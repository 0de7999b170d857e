package nephele.engine.portal.ground;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.UnaryOperator;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.portal.Aperture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Planes over fields whose nearest plane is known. */
class GroundSeatTest {
    private static final Aperture APERTURE = Aperture.of(PortalShape.RECTANGLE, 1.2, 2.1);

    /** The direction of −z along the surface. */
    private static final UnaryOperator<Vec3> UPRIGHT = normal -> {
        Vec3 north = new Vec3(0, 0, -1);
        return Directions.unit(north.addScaled(-north.dot(normal), normal));
    };

    private static Vec3 on(HeightField field, double x, double z) {
        return new Vec3(x, HeightFieldSurface.y(field, x, z), z);
    }

    private static GroundSeat seat(HeightField field, double x, double z) {
        return GroundSeat.over(field, on(field, x, z), "p", APERTURE, UPRIGHT);
    }

    /** Ridges and troughs of ±a, three each under the aperture, on a slope: no plane is nearer than a. */
    private static HeightField ridges(double metres, double slope, double cell) {
        int samples = (int) Math.round(12 / cell) + 1;
        return HeightField.of(
                new Vec3(-6, 0, -6),
                cell,
                samples,
                samples,
                (column, row) ->
                        metres * (Math.round(column * cell / 0.4) % 2 == 0 ? 1 : -1) + slope * (row * cell - 6));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.2, 0.4})
    void nineMillimetresPassAndElevenDoNot(double cell) {
        GroundSeat nine = seat(ridges(0.009, 0, cell), 0.13, -0.4);
        assertTrue(nine.isEven(), nine.toString());
        assertEquals(0.009, nine.unevenMetres(), 1e-4);
        assertEquals(0.009, nine.portal().centre().y(), 1e-4);
        assertEquals(1, nine.portal().normal().y(), 1e-5);
        HeightField field = ridges(0.011, 0, cell);
        GroundSeat eleven = seat(field, 0.13, -0.4);
        assertFalse(eleven.isEven(), eleven.toString());
        assertEquals(0.011, eleven.measuredUneven(field), 1e-4);
    }

    /** Heights along y shrink by the cosine when measured along the normal. */
    @ParameterizedTest
    @ValueSource(doubles = {10, 20, 30, 60, 80})
    void slopesDoNotMatter(double degrees) {
        double slope = Math.tan(Math.toRadians(degrees));
        double cosine = Math.cos(Math.toRadians(degrees));
        GroundSeat nine = seat(ridges(0.009 / cosine, slope, 0.1), 0.13, 0);
        assertTrue(nine.isEven(), nine.toString());
        assertEquals(cosine, nine.portal().normal().y(), 2e-3);
        assertFalse(seat(ridges(0.0112 / cosine, slope, 0.1), 0.13, 0).isEven());
    }

    /** A lone bump, which hardly moves a least-squares plane. */
    @Test
    void theNearestPlaneIsNotThatOfLeastSquares() {
        HeightField bump = HeightField.of(
                new Vec3(-6, 0, -6), 0.2, 61, 61, (column, row) -> column == 30 && row == 30 ? 0.019 : 0);
        GroundSeat seat = seat(bump, 0, 0);
        assertTrue(seat.isEven(), seat.toString());
        assertEquals(0.0095, seat.unevenMetres(), 1e-4);
        assertEquals(0.019, seat.portal().centre().y(), 1e-4);
        HeightField higher = HeightField.of(
                new Vec3(-6, 0, -6), 0.2, 61, 61, (column, row) -> column == 30 && row == 30 ? 0.021 : 0);
        assertFalse(seat(higher, 0, 0).isEven());
    }

    /** Every triangle under aperture and rim is behind the portal, by at most twice the deviation. */
    @Test
    void noGroundIsInFrontOfThePortal() {
        for (int place = 0; place < 20; place++) {
            HeightField field = HeightField.of(
                    new Vec3(-6, 0, -6),
                    0.15,
                    81,
                    81,
                    (column, row) -> 0.4 * Math.sin(0.05 * column)
                            + 0.004 * Math.sin(2.1 * column + row)
                            + 0.3 * Math.cos(0.04 * row));
            GroundSeat seat = seat(field, -1 + 0.1 * place, 0.07 * place);
            double step = GroundSeat.stepMetres(List.of(field), seat.portal());
            assertTrue(seat.isEven(), seat.toString());
            assertEquals(2 * seat.unevenMetres(), step, 1e-9);
            assertEquals(0, ApertureGround.under(field, seat.portal()).highest(), 1e-12);
        }
    }

    /** The plane over a point is the one over the ground behind the portal's centre: an edited level keeps it. */
    @Test
    void aSeatIsItsOwnSeat() {
        HeightField field = HeightField.of(
                new Vec3(-6, 0, -6),
                0.3,
                41,
                41,
                (column, row) -> 0.5 * Math.sin(0.1 * column) + 0.006 * Math.sin(2 * column + 1.3 * row));
        for (int place = 0; place < 20; place++) {
            Vec3 on = on(field, -2 + 0.2 * place, 0.17 * place);
            GroundSeat seat = GroundSeat.over(field, on, "p", APERTURE, UPRIGHT);
            Vec3 centre = seat.portal().centre();
            double raised = centre.minus(on).dot(seat.portal().normal());
            GroundSeat again = GroundSeat.over(
                    field, centre.addScaled(-raised, seat.portal().normal()), "p", APERTURE, UPRIGHT);
            assertEquals(0, centre.minus(again.portal().centre()).length(), 1e-9);
        }
    }

    /** Far from the origin, of cells of 10 m, on the smallest grid. */
    @ParameterizedTest
    @CsvSource({"0, 1", "10000, 10", "-1000000, 10"})
    void twoByTwoSamplesAreOnePlaneOrTwo(double far, double cell) {
        HeightField plane = HeightField.of(
                new Vec3(far, 0, far), 4 * cell, 2, 2, (column, row) -> (0.3 * column + 0.2 * row) * 4 * cell);
        GroundSeat seat = seat(plane, far + 2 * cell, far + 2 * cell);
        assertTrue(seat.isEven() && seat.unevenMetres() < 1e-5, seat.toString());
        HeightField folded =
                HeightField.of(new Vec3(far, 0, far), 4 * cell, 2, 2, (column, row) -> column == row ? 0 : cell);
        assertFalse(seat(folded, far + 2 * cell, far + 2 * cell).isEven());
    }

    @Test
    void aWallOnATerrainIsNotOnGround() {
        HeightField field = ridges(0.002, 0, 0.2);
        var wall = nephele.engine.portal.Portal.facing(new Vec3(0, 0, 1), new Vec3(0, 1, 0));
        for (double y = -1.3; y < 1.3; y += 0.1) {
            var portal = new nephele.engine.portal.Portal("w", new Vec3(0.1, y, 0), wall, APERTURE);
            assertEquals(GroundSeat.NO_GROUND, GroundSeat.stepMetres(List.of(field), portal));
        }
    }
}
