package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Billboards;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep.Rotate;
import nephele.engine.level.ModelPlacement.TransformStep.Scale;
import nephele.engine.level.ModelPlacement.TransformStep.Translate;
import nephele.engine.level.Terrain;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.reference.PathIntegrator.Estimation;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Whatever emits light gives as much by rays aimed at it as by paths that happen to meet it, and with less noise. */
class EmissiveSurfacesTest {
    private static final double MOST_SIGMAS = 4;
    private static final int PATHS = 12_000;
    private static final Vec3 AT = new Vec3(0.4, 1, 0);
    private static final TestAssets HILL =
            TestTerrain.map(9, (column, row) -> (int) (65535 * Math.max(0, 1 - Math.hypot(column - 4, row - 4) / 4)));

    private enum Lit {
        BOX {
            @Override
            Level on(TestLevel floor) {
                return floor.box("glow", AT, new Vec3(0.5, 0.3, 0.4)).level();
            }
        },
        CUBE {
            @Override
            Level on(TestLevel floor) {
                return floor.body(new Body.Box("b", AT, new Vec3(0.5, 0.3, 0.4), 1, "glow", 0, 0))
                        .level();
            }
        },
        CAPSULE {
            @Override
            Level on(TestLevel floor) {
                return floor.body(new Body.Capsule("b", AT, 0.2, 0.9, 1, "glow", 0, 0))
                        .level();
            }
        },
        /** The half that would stick out of the wall towards the eye is elsewhere. */
        BALL_IN_A_PORTAL {
            @Override
            Level on(TestLevel floor) {
                return floor.box("grey", new Vec3(0, 0.8, 0.05), new Vec3(3, 1.6, 0.1))
                        .box("grey", new Vec3(40, 0.8, 0.05), new Vec3(3, 1.6, 0.1))
                        .portal("a", "b", new Vec3(0, 1, 0), new Vec3(0, 0, -1), 1.6, 1.1)
                        .portal("b", "a", new Vec3(40, 1, 0), new Vec3(0, 0, -1), 1.6, 1.1)
                        .body(new Body.Sphere("b", AT, 0.3, 1, "glow", 0, 0))
                        .box("glow", new Vec3(-1, 1.1, 1.8), TestLevel.grey(0.4))
                        .level();
            }
        },
        MODEL {
            @Override
            Level on(TestLevel floor) {
                return floor.model("cone_1_3_6_1.3d", "glow", steps()).level();
            }
        },
        PLANTED {
            @Override
            Level on(TestLevel floor) {
                return floor.planted(new ModelPlacement("f", "cone_1_3_6_1.3d", null, List.of(steps()), "glow", false)
                                .over(new Billboards.Field(null, 5, 6, 0.5, null, 90, null), 0.5))
                        .level();
            }
        },
        TERRAIN {
            @Override
            Level on(TestLevel floor) {
                Terrain hill = new Terrain(
                        "t",
                        "map.r16",
                        AT.plus(new Vec3(0, -0.9, -1)),
                        new Terrain.Sides(2, 2),
                        new Terrain.HeightRange(0, 1.5),
                        List.of(
                                new Terrain.Layer("grey", -1e7, 0.5, 0.4, 0, 90),
                                new Terrain.Layer("glow", 0.5, 1e7, 0.4, 0, 90)),
                        false);
                return floor.level().withTerrains(List.of(hill));
            }
        };

        abstract Level on(TestLevel floor);
    }

    private static ModelPlacement.TransformStep[] steps() {
        return new ModelPlacement.TransformStep[] {
            new Translate(AT), new Scale(new Vec3(0.2, 0.2, 0.3)), new Rotate(new Vec3(1, 0, 0), 70)
        };
    }

    private record Mean(double value, double error) {
        static Mean of(Level level, Estimation estimation) {
            AssetSource assets = level.terrains().isEmpty() ? TestAssets.NONE : HILL;
            TracedLevel traced = TracedLevel.of(PlacedLevel.of(level, assets), ColourDecoding.SRGB);
            Pinhole eye = Traced.eye(new Vec3(0, 1.2, 4), new Vec3(0, 0, 1), 0.2);
            Tracer tracer = traced.tracer(eye, new TraceSettings(1, 1, PATHS, 1, 1, LightTransport.FULL), estimation);
            SampleSequence sequence = new SampleSequence(estimation.ordinal());
            double sum = 0;
            double squares = 0;
            for (int i = 0; i < PATHS; i++) {
                SampleSequence.PixelSample sample = sequence.sample(0, 0, i);
                double radiance = tracer.radiance(
                                eye.direction(
                                        sample.inPixel().x(), sample.inPixel().y()),
                                sample)
                        .y;
                sum += radiance;
                squares += radiance * radiance;
            }
            double mean = sum / PATHS;
            return new Mean(mean, Math.sqrt((squares / PATHS - mean * mean) / PATHS));
        }
    }

    @ParameterizedTest
    @EnumSource
    void givesTheSameLightByAimedRaysAndByPathsThatMeetIt(Lit lit) {
        Material glow = new Material("glow", TestLevel.grey(0.5), null, null, null, null, new Vec3(30, 20, 10), 1);
        Level level = lit.on(new TestLevel()
                .skyLight()
                .material(glow)
                .gloss("grey", TestLevel.grey(0.7), 0.4, 0)
                .box("grey", new Vec3(0, -0.1, 0), new Vec3(6, 0.2, 6)));
        Mean aimed = Mean.of(level, Estimation.AIMED);
        Mean met = Mean.of(level, Estimation.MET);
        Mean both = Mean.of(level, Estimation.BOTH);
        String all = aimed + ", " + met + ", " + both;
        assertEquals(met.value, aimed.value, MOST_SIGMAS * Math.hypot(met.error, aimed.error), all);
        assertEquals(met.value, both.value, MOST_SIGMAS * Math.hypot(met.error, both.error), all);
        assertTrue(both.error < 0.95 * met.error && met.error < 0.1 * met.value, all);
    }
}
