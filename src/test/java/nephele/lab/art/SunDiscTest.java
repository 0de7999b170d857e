package nephele.lab.art;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SunDiscTest {
    private static final int SIDE = 128;
    private static final Sky.Atmosphere SKY = Sky.Atmosphere.CLEAR;

    private static Sun sun(double elevationDegrees) {
        double elevation = Math.toRadians(elevationDegrees);
        // Near an edge of the cube, so that the disc is in two pictures.
        return new Sun(
                new Vec3(
                        Math.cos(elevation) * Math.sqrt(0.5),
                        Math.sin(elevation),
                        -Math.cos(elevation) * Math.sqrt(0.5)),
                new Vec3(4, 4, 4),
                true);
    }

    /** Returns the flux of pictures, per unit area perpendicular to it, from the solid angles of their pixels. */
    private static double flux(List<float[]> faces) {
        double flux = 0;
        for (float[] rgb : faces) {
            for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
                double s = 2 * (pixel % SIDE + 0.5) / SIDE - 1;
                double t = 2 * (pixel / SIDE + 0.5) / SIDE - 1;
                flux += rgb[3 * pixel] * Math.pow(1 + s * s + t * t, -1.5) * 4 / (SIDE * SIDE);
            }
        }
        return flux;
    }

    @ParameterizedTest
    @ValueSource(doubles = {80, 35, 5, 1})
    void theDiscHasTheSunsLightAsAirAndCloudsLeaveIt(double elevationDegrees) {
        List<float[]> faces =
                Stream.generate(() -> new float[3 * SIDE * SIDE]).limit(6).toList();
        Sun sun = sun(elevationDegrees);
        var baked = new BakedSkybox(SIDE, faces, 0.25);
        baked.add(SunDisc.of(SKY, sun, Vec3.ZERO, 0.25).orElseThrow());
        double expected = 0.25
                * sun.irradiance().x()
                * Daylight.air(SKY)
                        .transmittance(0, sun.directionTowardsSun().y())
                        .x();
        assertEquals(expected, flux(faces), 0.03 * expected);
        assertTrue(baked.discPixels() >= 1 && baked.discPixels() < 30, "pixels: " + baked.discPixels());
        assertEquals(0, baked.loss().clipped(), "the disc is told apart");
    }

    @Test
    void theHorizonCutsTheDiscAndHidesIt() {
        SunDisc half = SunDisc.of(SKY, sun(0), Vec3.ZERO, 1).orElseThrow();
        assertEquals(Vec3.ZERO, half.towards(new Vec3(Math.sqrt(0.5), -0.001, -Math.sqrt(0.5))));
        assertTrue(
                half.towards(new Vec3(Math.sqrt(0.5), 0.001, -Math.sqrt(0.5))).x() > 0);
        assertTrue(SunDisc.of(SKY, sun(-1), Vec3.ZERO, 1).isEmpty());
        assertTrue(SunDisc.of(SKY, sun(-1), new Vec3(0, 10_000, 0), 1).isPresent(), "a high eye sees it longer");
    }
}
