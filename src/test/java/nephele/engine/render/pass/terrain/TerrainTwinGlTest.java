package nephele.engine.render.pass.terrain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.Terrain;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.reference.VisibleSurface;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.LayerMixing;
import nephele.engine.scene.View;
import nephele.host.draw.IdLevel;
import nephele.lab.bake.TracedPictures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Drawn terrains equal traced ones pixel by pixel: shapes, layers, normals, lamps, shadows, light of the sky. */
class TerrainTwinGlTest {
    private static final int SIZE = 96;
    private static final TestAssets MAP = TestTerrain.map(70, TestTerrain::wavy);

    private static TestLevel materials() {
        return new TestLevel()
                .material("low", new Vec3(0.2, 0.5, 0.1))
                .material("high", new Vec3(0.7, 0.7, 0.8))
                .material(new Material("steep", new Vec3(0.5, 0.3, 0.2), null, 0.6, 0.2, null, Vec3.ZERO, 1));
    }

    private static Level on(TestLevel level, double sizeX, Vec3 centre) {
        List<Terrain.Layer> layers = List.of(
                new Terrain.Layer("low", -1e7, 5, 2, 0, 25),
                new Terrain.Layer("high", 5, 1e7, 2, 0, 25),
                new Terrain.Layer("steep", -1e7, 1e7, 0, 25, 90));
        return level.level()
                .withTerrains(List.of(new Terrain(
                        "t",
                        "map.r16",
                        centre,
                        new Terrain.Sides(sizeX, 64),
                        new Terrain.HeightRange(0, 10),
                        layers,
                        false)));
    }

    /** Without shadows, where only rounding differs, at most one value in a hundred, at an edge, differs. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void lightWithoutShadowsIsTheSame(boolean sunny) {
        TestLevel level = sunny
                ? materials().ambient(0.2).sun(new Vec3(0.4, 0.7, 0.5), 3)
                : materials()
                        .ambient(0.2)
                        .light(new Light.Point("l", new Vec3(3, 12, 3), TestLevel.grey(90), 60, false));
        Twins both = Twins.of(on(level, 64, Vec3.ZERO), Vec3.ZERO, 1);
        int differing = both.differing(0.02);
        assertTrue(differing < 0.02 * both.drawn.length, differing + " of " + both.drawn.length + " values differ");
    }

    private static int wave(int x, int y, int side) {
        double turn = 2 * Math.PI / side;
        int red = (int) (150 + 90 * Math.sin(turn * x) * Math.cos(turn * y));
        int green = (int) (140 + 80 * Math.cos(turn * x));
        int blue = (int) (128 + 70 * Math.sin(turn * y + 1));
        return red << 16 | green << 8 | blue;
    }

    private static int bumps(int x, int y, int side) {
        double turn = 2 * Math.PI / side;
        int red = (int) (128 + 60 * Math.sin(turn * x));
        int green = (int) (128 + 50 * Math.cos(turn * y));
        int alpha = (int) (200 + 50 * Math.sin(turn * (x + y)));
        return alpha << 24 | red << 16 | green << 8 | 230;
    }

    private static Material pictured(String id, String picture, String normals, Double roughness, double metres) {
        return new Material(id, TestLevel.grey(0.8), picture, roughness, null, normals, Vec3.ZERO, metres);
    }

    /** Pictures of two sizes, normal maps and roughness lie on slopes as {@code GroundProjections} says. */
    @ParameterizedTest
    @CsvSource({"true, 0.3", "false, 0.3", "false,"})
    void picturesAreTheSame(boolean ofOneSize, Double roughness) {
        int other = ofOneSize ? 32 : 16;
        TestAssets assets = TestTerrain.map(70, TestTerrain::wavy)
                .picture("a.png", 32, 32, (x, y) -> wave(x, y, 32))
                .picture("b.png", other, other, (x, y) -> wave(y, x, other))
                .seeThroughPicture("n.png", 32, 32, (x, y) -> bumps(x, y, 32))
                .seeThroughPicture("m.png", other, 2 * other, (x, y) -> bumps(x, y, other));
        TestLevel level = new TestLevel()
                .material(pictured("low", "a.png", null, roughness, 20))
                .material(pictured("high", "b.png", "m.png", roughness, 30))
                .material(pictured("steep", "a.png", "n.png", roughness, 25))
                .ambient(0.2)
                .sun(new Vec3(0.4, 0.7, 0.5), 3);
        Vec3 centre = new Vec3(7, 3, -5);
        Terrain said = on(level, 64, centre).terrains().get(0);
        Terrain high = new Terrain(
                "t",
                said.heightMap(),
                centre,
                said.sizeMetres(),
                new Terrain.HeightRange(0, 25),
                List.of(
                        new Terrain.Layer("low", -1e7, 12, 4, 0, 40),
                        new Terrain.Layer("high", 12, 1e7, 4, 0, 90),
                        new Terrain.Layer("steep", -1e7, 1e7, 0, 40, 90)),
                false);
        Twins both = Twins.of(level.level().withTerrains(List.of(high)), assets, centre.plus(new Vec3(0, 12, 0)), 1);
        int differing = both.differing(0.03);
        assertTrue(differing < 0.03 * both.drawn.length, differing + " of " + both.drawn.length + " values differ");
    }

    /** Plain colours that are mixed once differ only along the limits of layers, by as much as its pixels are wide. */
    @Test
    void theMixtureOfColoursCanBeMadeOnce() {
        Level level = on(materials().ambient(0.2).sun(new Vec3(0.4, 0.7, 0.5), 3), 64, Vec3.ZERO);
        Twins both = Twins.of(level, MAP, Vec3.ZERO, 8, Quality.HIGH.with("terrainLayers", LayerMixing.BAKED));
        assertEquals(1, both.mean(both.drawn) / both.mean(both.traced), 0.005);
        int differing = both.differing(0.1);
        assertTrue(differing < 0.08 * both.drawn.length, differing + " of " + both.drawn.length + " values differ");
    }

    /** With shadows and the sky, the mean agrees, and nearly all pixels. */
    @Test
    void shadowsAndSkyAreNearlyTheSame() {
        TestLevel level = materials()
                .skyLight()
                .sky(new Sky.Gradient(new Vec3(0.4, 0.6, 1), TestLevel.grey(0.8), TestLevel.grey(0.2)))
                .castingSun(new Vec3(0.8, 0.35, 0.3), 3)
                .box("low", new Vec3(0, 9, -3), new Vec3(2, 4, 2));
        Twins both = Twins.of(on(level, 64, Vec3.ZERO), Vec3.ZERO, 32);
        assertEquals(1, both.mean(both.drawn) / both.mean(both.traced), 0.015);
        int differing = both.differing(0.12);
        assertTrue(differing < 0.06 * both.drawn.length, differing + " of " + both.drawn.length + " values differ");
    }

    /** Identity colours differ at no pixel that is away from edges: oblong cells, far from the world's origin. */
    @ParameterizedTest
    @CsvSource({"64, 0", "20, 0", "64, 100000"})
    void theSamePixelsShowTheGround(double sizeX, double out) {
        Vec3 centre = new Vec3(out, 0, -out);
        Level ids = IdLevel.of(
                on(materials().box("low", centre.plus(new Vec3(0, 9, -3)), new Vec3(2, 4, 2)), sizeX, centre));
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(centre.plus(new Vec3(2, 13, 14)), centre.plus(new Vec3(0, 6, 0)));
            int[] drawn = offscreen.pixels(ids, MAP, view, RenderSettings.of(Output.PLAIN));
            VisibleSurface sight = TracedLevel.of(PlacedLevel.of(ids, MAP), ColourDecoding.AS_STORED)
                    .sight(TracedPictures.pinhole(view));
            int differing = 0;
            int ground = 0;
            for (int i = 0; i < drawn.length; i++) {
                int surface = sight.at((i % SIZE + 0.5) / SIZE, (i / SIZE + 0.5) / SIZE);
                int expected = surface == VisibleSurface.NOTHING ? 0 : IdLevel.colour(surface);
                ground += surface == 1 ? 1 : 0;
                differing += expected == drawn[i] ? 0 : 1;
            }
            assertTrue(ground > drawn.length / 3, ground + " pixels of ground");
            assertTrue(differing <= 8, differing + " pixels differ");
        }
    }

    /** The drawn and the traced picture. */
    private record Twins(float[] drawn, float[] traced) {
        static Twins of(Level level, Vec3 centre, int samples) {
            return of(level, MAP, centre, samples);
        }

        static Twins of(Level level, TestAssets assets, Vec3 centre, int samples) {
            return of(level, assets, centre, samples, Quality.HIGH);
        }

        static Twins of(Level level, TestAssets assets, Vec3 centre, int samples, Quality quality) {
            try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
                View view = offscreen.view(centre.plus(new Vec3(2, 16, 14)), centre.plus(new Vec3(0, 2, 0)));
                float[] drawn = offscreen
                        .radiance(level, assets, List.of(view), quality)
                        .get(0);
                TracedLevel twin = TracedLevel.of(PlacedLevel.of(level, assets), ColourDecoding.SRGB);
                TraceSettings settings = new TraceSettings(SIZE, SIZE, samples, 1, 2);
                return new Twins(
                        drawn, ReferencePicture.trace(twin, TracedPictures.pinhole(view), settings, done -> {}));
            }
        }

        int differing(double share) {
            int differing = 0;
            for (int i = 0; i < drawn.length; i++) {
                differing += Math.abs(drawn[i] - traced[i]) > share * Math.max(traced[i], 0.05) ? 1 : 0;
            }
            return differing;
        }

        double mean(float[] picture) {
            double sum = 0;
            for (float value : picture) {
                sum += value;
            }
            return sum / picture.length;
        }
    }
}
