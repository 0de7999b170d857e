package nephele.engine.level.billboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.Billboards.Facing;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

class FacingAxesTest {
    private static final int DIRECTIONS = 3600;
    private static final Vec3 VIEW_RIGHT = new Vec3(0.6, 0, -0.8);
    private static final Vec3 VIEW_UP = new Vec3(0, 1, 0);
    private static final double[] ELEVATIONS = {-89.99, -60, -5, 0, 5, 60, 89.99};

    private static Vec3 direction(int index, double elevationDegrees) {
        double azimuth = 2 * Math.PI * index / DIRECTIONS;
        double elevation = Math.toRadians(elevationDegrees);
        return new Vec3(
                Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation), Math.cos(elevation) * Math.cos(azimuth));
    }

    private static FacingAxes axes(Facing facing, Vec3 toEye) {
        FacingAxes axes = FacingAxes.of(facing, toEye, VIEW_RIGHT, VIEW_UP, 0.3);
        assertEquals(1, axes.right().length(), 1e-12);
        assertEquals(1, axes.up().length(), 1e-12);
        assertEquals(0, axes.right().dot(axes.up()), 1e-12);
        return axes;
    }

    @Test
    void sphericalFacesTheEyeFromEverywhere() {
        for (double elevation : ELEVATIONS) {
            for (int i = 0; i < DIRECTIONS; i++) {
                Vec3 toEye = direction(i, elevation);
                FacingAxes axes = axes(Facing.SPHERICAL, toEye.scaled(37));
                assertEquals(1, axes.front().dot(toEye), 1e-12);
                assertTrue(axes.up().y() > 0, "upright");
            }
        }
    }

    @Test
    void cylindricalStandsUprightAndTurnsToTheEye() {
        for (double elevation : ELEVATIONS) {
            for (int i = 0; i < DIRECTIONS; i++) {
                Vec3 toEye = direction(i, elevation);
                FacingAxes axes = axes(Facing.CYLINDRICAL, toEye.scaled(0.01));
                Vec3 flat = new Vec3(toEye.x(), 0, toEye.z());
                assertEquals(flat.length(), axes.front().dot(toEye), 1e-12);
                assertEquals(new Vec3(0, 1, 0), axes.up());
            }
        }
    }

    /** A small step of the eye turns the picture by a small angle; nothing flips on the whole circle. */
    @Test
    void nothingFlips() {
        for (Facing facing : new Facing[] {Facing.SPHERICAL, Facing.CYLINDRICAL, Facing.SCREEN, Facing.CROSSED}) {
            for (double elevation : ELEVATIONS) {
                Vec3 before = axes(facing, direction(DIRECTIONS - 1, elevation)).right();
                for (int i = 0; i < DIRECTIONS; i++) {
                    Vec3 right = axes(facing, direction(i, elevation)).right();
                    assertTrue(right.dot(before) > 0.999998, facing + " at " + i);
                    before = right;
                }
            }
        }
    }

    @Test
    void straightAboveBelowAndAtTheEyeItTakesTheSideOfTheView() {
        for (Facing facing : Facing.values()) {
            for (Vec3 toEye : new Vec3[] {new Vec3(0, 5, 0), new Vec3(0, -5, 0), Vec3.ZERO, new Vec3(0, 1e7, 0)}) {
                FacingAxes axes = axes(facing, toEye);
                if (facing == Facing.SPHERICAL || facing == Facing.CYLINDRICAL) {
                    assertEquals(1, axes.right().dot(VIEW_RIGHT), 1e-12);
                }
            }
        }
    }

    /** The formula is right on one half of the circle, half a turn off on the other, and has 0 / 0 nowhere else. */
    @Test
    void theSourcesFormulaIsWrongInHalfOfTheDirections() {
        int away = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            Vec3 toEye = direction(i, 0);
            double facing = axes(Facing.SOURCE, toEye).front().dot(toEye);
            assertEquals(1, Math.abs(facing), 1e-9);
            away += facing < 0 ? 1 : 0;
        }
        assertEquals(DIRECTIONS / 2, away, 1);
        assertEquals(Math.PI / 2, FacingAxes.sourceAngle(3, 0), 1e-12);
        assertEquals(-Math.PI / 2, FacingAxes.sourceAngle(-3, 0), 1e-12);
        assertEquals(0, FacingAxes.sourceAngle(0, 0));
    }
}
