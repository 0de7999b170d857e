package nephele.lab.bake;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.NightSky;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.reference.sky.SunDisc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BakedSkyboxTest {
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
        List<float[]> faces = black();
        Sun sun = sun(elevationDegrees);
        var baked = new BakedSkybox(SIDE, faces, 0.25);
        baked.add(disc(sun), 0, 0.25);
        double expected = 0.25
                * sun.irradiance().x()
                * Daylight.air(SKY)
                        .transmittance(0, sun.directionTowardsSun().y())
                        .x();
        assertEquals(expected, flux(faces), 0.03 * expected);
        assertTrue(baked.discPixels() >= 1 && baked.discPixels() < 30, "pixels: " + baked.discPixels());
        assertEquals(0, baked.loss().clipped(), "the disc is told apart");
    }

    /** At a quarter of an hour to midnight of a full moon. */
    @Test
    void moonAndStarsAreInThePicturesAsCloudsLeaveThem() {
        var full = new Sky.Atmosphere(0.3, 1, 0.8, 1, 45, 20, 23.75, 0, 0.2666);
        Sun sun =
                Daylight.at(new TestLevel().sky(full).level().environment(), 0).sun();
        NightSky night = NightSky.of(full, sun, 0).orElseThrow();
        List<float[]> clear = black();
        new BakedSkybox(SIDE, clear, 1).add(night, towards -> 1);
        List<float[]> dim = black();
        new BakedSkybox(SIDE, dim, 1).add(night, towards -> 0.25);
        assertEquals(0.25 * flux(clear), flux(dim), 1e-4 * flux(clear));
        double moon = 0;
        for (int i = 0; i < 1000; i++) {
            double radius = Math.sqrt((i + 0.5) / 1000) * NightSky.MOON_RADIUS_RADIANS;
            Vec3 across = Directions.perpendicular(night.towardsMoon());
            Vec3 along = night.towardsMoon().cross(across);
            Vec3 off = Directions.combined(across, radius * Math.cos(2.4 * i), along, radius * Math.sin(2.4 * i));
            moon += night.moon(Directions.unit(night.towardsMoon().plus(off))).x() / 1000;
        }
        moon *= Math.PI * NightSky.MOON_RADIUS_RADIANS * NightSky.MOON_RADIUS_RADIANS;
        long lit = clear.stream().mapToLong(BakedSkyboxTest::lit).sum();
        assertTrue(lit > 50, "pixels with moon or stars: " + lit);
        assertTrue(flux(clear) > 0.97 * moon && flux(clear) < 1.3 * moon, flux(clear) + " with a moon of " + moon);
    }

    private static SunDisc disc(Sun sun) {
        return SunDisc.of(new TestLevel().sky(SKY).level().environment().with(sun))
                .orElseThrow();
    }

    private static List<float[]> black() {
        return Stream.generate(() -> new float[3 * SIDE * SIDE]).limit(6).toList();
    }

    private static long lit(float[] rgb) {
        return IntStream.range(0, rgb.length / 3).filter(i -> rgb[3 * i] > 0).count();
    }

    @Test
    void theHorizonCutsTheDiscAndHidesIt() {
        SunDisc half = disc(sun(0));
        assertEquals(Vec3.ZERO, half.towards(new Vec3(Math.sqrt(0.5), -0.001, -Math.sqrt(0.5)), 0));
        assertTrue(half.towards(new Vec3(Math.sqrt(0.5), 0.001, -Math.sqrt(0.5)), 0)
                        .x()
                > 0);
        Vec3 below = new Vec3(Math.sqrt(0.5), -0.017, -Math.sqrt(0.5));
        assertEquals(Vec3.ZERO, disc(sun(-1)).towards(Directions.unit(below), 0));
        assertTrue(disc(sun(-1)).towards(Directions.unit(below), 10_000).x() > 0, "a high eye sees it longer");
    }
}
