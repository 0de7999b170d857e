package nephele.engine.scene.impostor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The square of directions, and the views that show one, over 3,600 directions. */
class HemiOctahedronTest {
    private static final int SIDE = ImpostorAtlas.SIDE;

    /** Returns directions all around, at elevations from the horizon to the zenith. */
    private static List<Vec3> directions() {
        List<Vec3> all = new ArrayList<>();
        for (int i = 0; i < 3600; i++) {
            double azimuth = Math.toRadians(i % 120 * 3 + 0.7);
            double elevation = Math.toRadians((i / 120) * 90.0 / 29);
            all.add(direction(azimuth, elevation));
        }
        return all;
    }

    private static Vec3 direction(double azimuth, double elevation) {
        return new Vec3(
                Math.cos(elevation) * Math.cos(azimuth), Math.sin(elevation), Math.cos(elevation) * Math.sin(azimuth));
    }

    @Test
    void aDirectionIsThatOfItsPoint() {
        for (Vec3 d : directions()) {
            double u = AtlasView.u(d);
            double v = AtlasView.v(d);
            assertTrue(Math.abs(u) <= 1 + 1e-12 && Math.abs(v) <= 1 + 1e-12, () -> d + ": " + u + ", " + v);
            assertTrue(AtlasView.direction(u, v).minus(d).length() < 1e-9, d.toString());
        }
    }

    @Test
    void theBorderIsTheHorizon() {
        for (int i = 0; i <= 20; i++) {
            assertEquals(0, AtlasView.direction(-1 + i / 10.0, 1).y(), 1e-12);
            assertEquals(0, AtlasView.direction(-1, -1 + i / 10.0).y(), 1e-12);
        }
        assertEquals(1, AtlasView.direction(0, 0).y(), 1e-12);
        Vec3 below = direction(1, -0.6);
        Vec3 level = direction(1, 0);
        assertEquals(AtlasView.u(level), AtlasView.u(below), 1e-12);
        assertEquals(AtlasView.v(level), AtlasView.v(below), 1e-12);
    }

    /** Returns the weight of each view. */
    private static double[] weights(Vec3 direction) {
        ViewBlend blend = ViewBlend.of(direction, SIDE);
        double[] all = new double[SIDE * SIDE];
        for (int i = 0; i < 3; i++) {
            assertTrue(blend.weights()[i] >= -1e-12, direction::toString);
            all[blend.views()[i]] += blend.weights()[i];
        }
        return all;
    }

    @Test
    void weightsAddUpToOneAndChangeContinuously() {
        double step = 1e-4;
        for (Vec3 d : directions()) {
            double[] here = weights(d);
            double sum = 0;
            for (double weight : here) {
                sum += weight;
            }
            assertEquals(1, sum, 1e-12);
            for (Vec3 to : List.of(new Vec3(step, 0, 0), new Vec3(0, step, 0), new Vec3(0, 0, step))) {
                double[] there = weights(d.plus(to).scaled(1 / d.plus(to).length()));
                for (int view = 0; view < here.length; view++) {
                    assertEquals(here[view], there[view], 20 * step, () -> d + " towards " + to);
                }
            }
        }
    }

    /** A view alone shows its own direction. */
    @Test
    void aViewIsChosenForItsOwnDirection() {
        KindShape shape = new KindShape(null, Vec3.ZERO, 1, 2, 2);
        for (int view = 0; view < SIDE * SIDE; view++) {
            AtlasView own = AtlasView.at(view % SIDE, view / SIDE, shape);
            assertEquals(1, weights(own.towards())[view], 1e-9);
            assertEquals(0, own.right().dot(own.towards()), 1e-12);
            assertEquals(0, own.right().y(), 1e-12);
            assertEquals(1, own.up().length(), 1e-12);
            assertTrue(own.up().y() >= -1e-12);
        }
    }
}
