package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import nephele.engine.asset.TestAssets;
import nephele.engine.atmosphere.AerialTable;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.reference.sky.LevelClouds;
import nephele.engine.render.Offscreen;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Clouds with shafts shade the air, as it is drawn and as the reference traces it. */
class AirShadeGlTest {
    private static final int SIDE = 120;
    /** One of so many pixels is compared along each side. */
    private static final int STRIDE = 8;

    private static final double IRRADIANCE = 1000;
    private static final Vec3 EYE = new Vec3(0, 2, 0);
    private static final Vec3 SUN = new Vec3(0.6, 0.48, -0.64);
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final double WALL_METRES = 9000;
    private static final Cloud.Extent LAYER = new Cloud.Extent.Layer(5000, 500);
    private static final Cloud.Extent HEAP =
            new Cloud.Extent.Volume(new Vec3(3000, 2500, -7500), new Vec3(4000, 1500, 4000));
    private static final AirTables CLEAR = AirTables.of(Air.CLEAR);

    private static Cloud cloud(Cloud.Extent extent, double extinctionPerMetre, boolean shafts) {
        return new Cloud(
                "c",
                extent,
                CloudTechnique.AUTO,
                new Cloud.Density.Ellipsoid(),
                extinctionPerMetre,
                1,
                0.85,
                Cloud.BackLobe.NONE,
                Cloud.Motion.STILL,
                shafts,
                Cloud.Tolerance.USUAL);
    }

    /** A black wall, so that nothing is seen but air. */
    private static TestLevel wall(Vec3 towardsSun) {
        return new TestLevel()
                .sky(Sky.Atmosphere.CLEAR)
                .sun(towardsSun, IRRADIANCE)
                .material(new Material("black", Vec3.ZERO, null, null, null, null, Vec3.ZERO, 1))
                .box("black", new Vec3(0, 0, -WALL_METRES - 50), new Vec3(60_000, 60_000, 100));
    }

    private static Level level(Cloud cloud) {
        return wall(SUN).cloud(cloud).level();
    }

    /** Looks at the wall up to a height of 3,600 m; the lower half of the picture is the ground below y = 0. */
    private static View view(Vec3 eye, Vec3 towards) {
        return View.lookAt(eye, eye.plus(towards), UP, new Projection(2 * Math.atan(0.4), 1, 0.05, 2e5));
    }

    private static View view() {
        return view(EYE, new Vec3(0, 0, -1));
    }

    private static int[] pixels() {
        return IntStream.range(0, SIDE * SIDE)
                .filter(i -> i % SIDE % STRIDE == STRIDE / 2 && i / SIDE % STRIDE == STRIDE / 2)
                .toArray();
    }

    private static Vec3 pathTo(int pixel) {
        double x = 0.4 * ((2 * (pixel % SIDE) + 1.0) / SIDE - 1);
        double y = 0.4 * ((2 * (pixel / SIDE) + 1.0) / SIDE - 1);
        return new Vec3(x, y, -1).scaled(WALL_METRES);
    }

    /** The sun below the layer is dimmed by the same factor everywhere, so all light that is scattered once is. */
    @Test
    void underAnEvenLayerAShareOfWhatIsScatteredOnceIsMissing() {
        double depth = 0.8;
        AerialTable all = new AerialTable(CLEAR, EYE.y(), SUN.y());
        AerialTable once = AerialTable.ofFirstScattering(CLEAR, EYE.y(), SUN.y());
        double share = -Math.expm1(-depth / SUN.y());
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            float[] seen = offscreen.radiance(level(cloud(LAYER, depth / 500, true)), TestAssets.NONE, view());
            for (int i : pixels()) {
                Vec3 path = pathTo(i);
                Vec3 away = path.scaled(1 / path.length());
                Vec3 lit = all.along(away, SUN, path.length()).radiance();
                Vec3 wanted = lit.addScaled(
                        -share, once.along(away, SUN, path.length()).radiance());
                for (int c = 0; c < 3; c++) {
                    double channel = wanted.toVector().get(c) * IRRADIANCE;
                    assertEquals(1, seen[3 * i + c] / channel, 4e-3, "pixel " + i + ", " + share);
                }
            }
        }
    }

    /** What a heap between the sun and the air takes, pixel by pixel, in the share of the light that could be taken. */
    @Test
    void theShadowOfAHeapIsWhereItIsTraced() {
        Level level = level(cloud(HEAP, 0.01, true));
        AirShade exact = shade(level.environment()).orElseThrow();
        AerialTable once = AerialTable.ofFirstScattering(CLEAR, EYE.y(), SUN.y());
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            float[] lit = offscreen.radiance(level(cloud(HEAP, 0.01, false)), TestAssets.NONE, view());
            float[] shaded = offscreen.radiance(level, TestAssets.NONE, view());
            double most = 0;
            double squares = 0;
            int count = 0;
            for (int i : pixels()) {
                Vec3 path = pathTo(i);
                if (EYE.y() + path.y() > 1500) {
                    continue; // The heap itself may be in front of the wall.
                }
                Vec3 away = path.scaled(1 / path.length());
                double full = once.along(away, SUN, path.length()).radiance().y() * IRRADIANCE;
                double wanted = mean(exact, away, path.length()).y / full;
                double seen = (lit[3 * i + 1] - shaded[3 * i + 1]) / full;
                most = Math.max(most, wanted);
                squares += (seen - wanted) * (seen - wanted);
                count++;
                assertEquals(wanted, seen, 0.06, "pixel " + i);
            }
            assertTrue(most > 0.3, "the heap takes " + most);
            assertEquals(0, Math.sqrt(squares / count), 0.02);
        }
    }

    private static Optional<AirShade> shade(Environment environment) {
        return AirShade.ofClouds(environment, LevelClouds.of(environment, TestAssets.NONE, 0, Optional.empty()));
    }

    private static Vector3d mean(AirShade exact, Vec3 away, double metres) {
        var random = new SplittableRandom(5);
        int estimates = 24;
        Vector3d sum = new Vector3d();
        for (int n = 0; n < estimates; n++) {
            sum.add(exact.taken(EYE, away, metres, random));
        }
        return sum.div(estimates);
    }

    /** Below the horizon the sun cannot cast a shadow along the ground; a cloud of no extinction has none. */
    @ParameterizedTest
    @ValueSource(doubles = {30, -2})
    void withoutAShadowThePictureIsThatWithoutShafts(double sunDegrees) {
        double sine = Math.sin(Math.toRadians(sunDegrees));
        Vec3 sun = new Vec3(0, sine, -Math.sqrt(1 - sine * sine));
        double perMetre = sunDegrees > 0 ? 0 : 0.01;
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            List<float[]> two = List.of(true, false).stream()
                    .map(shafts ->
                            wall(sun).cloud(cloud(HEAP, perMetre, shafts)).level())
                    .map(level -> offscreen.radiance(level, TestAssets.NONE, view()))
                    .toList();
            assertArrayEquals(two.get(1), two.get(0));
        }
    }

    /** The eye's space is that behind the portal: its straight line of sight through there has the same shadows. */
    @Test
    void throughAPortalTheShadowsAreThoseOfTheMovedEye() {
        Vec3 there = new Vec3(1800, 50, -500);
        Level level = wall(SUN)
                .cloud(cloud(HEAP, 0.01, true))
                .portal("a", "b", new Vec3(1800, 2, -500), new Vec3(0, 0, 1), 4, 4)
                .portal("b", "a", there, new Vec3(0, 0, -1), 4, 4)
                .level();
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            float[] through =
                    offscreen.radiance(level, TestAssets.NONE, view(new Vec3(1800, 2, -499), new Vec3(0, 0, -1)));
            float[] moved =
                    offscreen.radiance(level, TestAssets.NONE, view(there.plus(new Vec3(0, 0, 1)), new Vec3(0, 0, -1)));
            for (int i : pixels()) {
                if (pathTo(i).y() < 1300) { // The heap itself is another layer's picture.
                    assertEquals(1, through[3 * i] / moved[3 * i], 2e-3, "pixel " + i);
                }
            }
        }
    }
}
