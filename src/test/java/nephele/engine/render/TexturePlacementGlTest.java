package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.scene.View;
import nephele.lab.bake.TracedPictures;
import org.junit.jupiter.api.Test;

/** Pictures that are placed on faces are drawn as they are traced. */
class TexturePlacementGlTest {
    private static final int SIZE = 128;

    private static final TestAssets ASSETS = new TestAssets()
            .picture("tiles.png", 16, 16, (x, y) -> (x ^ y) * 0x0f0b07)
            .picture("leaning.png", 1, 1, (x, y) -> 0xc8a0d8)
            .picture("red.png", 1, 1, (x, y) -> 0xc04020);

    private static TestLevel lit() {
        return new TestLevel().ambient(0.2).sun(new Vec3(0.4, 0.7, 0.5), 3);
    }

    /** Returns one of each kind of solid with the placement on all faces. */
    private static Level shapes(TexturePlacement placement, TextureMapping mapping, Material material) {
        List<Solid> solids = List.of(
                new Solid.Box("b", "m", false, mapping, new Vec3(-1.5, 0.5, 0), TestLevel.grey(1), Map.of()),
                new Solid.Wedge(
                        "w", "m", false, mapping, new Vec3(0, 0.5, 0), TestLevel.grey(1.2), BoxFace.MINUS_X, Map.of()),
                new Solid.Prism("p", "m", false, mapping, new Vec3(1.5, 0.5, 0), 0.7, 1.3, 7, Map.of()));
        TestLevel level = lit().material(material);
        for (Solid solid : solids) {
            Solid painted = solid;
            for (String face : SolidFaces.names(solid)) {
                painted = SolidFaces.with(painted, face, new Solid.Face(null, null, placement));
            }
            level.solid(painted);
        }
        return level.level();
    }

    private static Material tiles() {
        return new Material("m", TestLevel.grey(1), "tiles.png", null, null, null, Vec3.ZERO, 2);
    }

    private static View view(Offscreen offscreen) {
        return offscreen.view(new Vec3(0.3, 1.6, 2.2), new Vec3(0, 0.4, 0));
    }

    @Test
    void aShiftByAWholeRepeatChangesNoPixel() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            float[] plain = draw(offscreen, null);
            assertArrayEquals(plain, draw(offscreen, new TexturePlacement(2, -4, 0, 1, 1)));
            assertTrue(differing(plain, draw(offscreen, new TexturePlacement(1, 0, 0, 1, 1)), 0.01) > 1000);
            assertTrue(differing(plain, draw(offscreen, new TexturePlacement(0, 0, 90, 1, 1)), 0.01) > 1000);
        }
    }

    private static float[] draw(Offscreen offscreen, TexturePlacement placement) {
        return offscreen.radiance(shapes(placement, TextureMapping.WORLD, tiles()), ASSETS, view(offscreen));
    }

    /** A map of one colour has no filter, so that directions of turned and mirrored normals are all that counts. */
    @Test
    void turnedNormalMapsAreTheTracersPixelByPixel() {
        Material leaning = new Material("m", TestLevel.grey(0.8), "red.png", 0.4, 0.3, "leaning.png", Vec3.ZERO, 1);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            float[] before = null;
            for (TexturePlacement placement : new TexturePlacement[] {
                null,
                new TexturePlacement(0.3, 0.1, 0, 0.5, 2),
                new TexturePlacement(0, 0, 90, 1, 1),
                new TexturePlacement(0.2, 0, -37, -0.7, 1.5),
                new TexturePlacement(0, 0, 0, 1, -1)
            }) {
                Level level = shapes(placement, TextureMapping.FACE, leaning);
                float[] drawn = offscreen.radiance(level, ASSETS, view(offscreen));
                float[] traced = traced(level, ASSETS, view(offscreen), 1);
                int seen = seen(traced);
                assertTrue(seen > 10_000, seen + " values");
                int off = differing(drawn, traced, 0.01);
                assertTrue(off < 0.01 * seen, off + " of " + seen + " values differ with " + placement);
                boolean isTurned = placement != null && placement.isTurned();
                assertTrue(!isTurned || differing(before, drawn, 0.01) > 1000, placement + " bends no normal");
                before = drawn;
            }
        }
    }

    /** Light of the sky and filters differ a little; pictures that lie elsewhere differ by a multiple of it. */
    @Test
    void theSampleIsDrawnAsItIsTraced() {
        LevelFile.Opened sample = LevelFile.load(Path.of("levels/samples/texture-placement.json"));
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(new Vec3(0.2, 1.2, 2.4), new Vec3(0, 0.6, 0));
            float[] traced = traced(sample.level(), sample.assets(), view, 32);
            double error = difference(offscreen.radiance(sample.level(), sample.assets(), view), traced);
            double elsewhere = difference(offscreen.radiance(unplaced(sample.level()), sample.assets(), view), traced);
            assertTrue(error < 0.5 * elsewhere, error + " is the mean difference, without placements " + elsewhere);
        }
    }

    private static Level unplaced(Level level) {
        List<Solid> solids = new ArrayList<>();
        for (Solid solid : level.solids()) {
            Solid bare = solid;
            for (var said : SolidFaces.authored(solid).entrySet()) {
                Solid.Face face = said.getValue();
                bare = SolidFaces.with(bare, said.getKey(), new Solid.Face(face.material(), face.portalable(), null));
            }
            solids.add(bare);
        }
        return level.with(level.materials(), solids, level.bodies(), level.models());
    }

    private static double difference(float[] drawn, float[] traced) {
        float[] some = blurred(drawn);
        float[] others = blurred(traced);
        double sum = 0;
        for (int i = 0; i < some.length; i++) {
            sum += Math.abs(some[i] - others[i]);
        }
        return sum / some.length;
    }

    private static float[] traced(Level level, AssetSource assets, View view, int samples) {
        TracedLevel twin = TracedLevel.of(PlacedLevel.of(level, assets), ColourDecoding.SRGB);
        TraceSettings settings = new TraceSettings(SIZE, SIZE, samples, 1, 2);
        return ReferencePicture.trace(twin, TracedPictures.pinhole(view), settings, done -> {});
    }

    private static int seen(float[] picture) {
        int seen = 0;
        for (float value : picture) {
            seen += value > 0 ? 1 : 0;
        }
        return seen;
    }

    private static int differing(float[] some, float[] others, double share) {
        int differing = 0;
        for (int i = 0; i < some.length; i++) {
            differing += Math.abs(some[i] - others[i]) > share * Math.max(others[i], 0.05) ? 1 : 0;
        }
        return differing;
    }

    /** Returns means over squares of 3 pixels: filters and noise differ there, places of a pattern do not. */
    private static float[] blurred(float[] picture) {
        float[] mean = new float[picture.length];
        for (int y = 1; y < SIZE - 1; y++) {
            for (int i = 3; i < 3 * SIZE - 3; i++) {
                for (int k = 0; k < 9; k++) {
                    mean[y * 3 * SIZE + i] += picture[(y + k / 3 - 1) * 3 * SIZE + i + 3 * (k % 3 - 1)] / 9;
                }
            }
        }
        return mean;
    }
}
