package nephele.engine.level.terrain;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.LayerMap;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.RecordCopy;
import nephele.engine.level.Terrain;
import nephele.engine.level.Terrain.Layer;
import nephele.engine.level.TestTerrain;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Paint replaces shares of a mixture. The terrain is 64 m square, with its least corner at (68, −62). */
class LayerPaintTest {
    private static final Terrain GROUND = RecordCopy.with(
            TestTerrain.said("t", "none", Layer.everywhere("a"), Layer.everywhere("b"), Layer.everywhere("c")),
            "centre",
            new Vec3(100, 7, -30));
    private static final double[] MIXED = {0.5, 0.25, 0.25};

    private static LayerMap map(int columns, int rows, int... layersAndWeights) {
        byte[] texels = new byte[layersAndWeights.length];
        for (int i = 0; i < texels.length; i++) {
            texels[i] = (byte) layersAndWeights[i];
        }
        return new LayerMap(columns, rows, texels);
    }

    private static double[] at(LayerMap map, double x, double z) {
        double[] weights = MIXED.clone();
        new LayerPaint(GROUND, map).over(x, z, weights);
        return weights;
    }

    @Test
    void weightsOfAnyMapAtAnyPlaceHaveASumOfOne() {
        Random random = new Random(3);
        for (int round = 0; round < 20; round++) {
            int columns = 2 + random.nextInt(6);
            int rows = 2 + random.nextInt(6);
            byte[] texels = new byte[2 * columns * rows];
            random.nextBytes(texels);
            for (int i = 0; i < texels.length; i += 2) {
                texels[i] = (byte) random.nextInt(3);
            }
            for (int place = 0; place < 200; place++) {
                double[] weights = at(
                        new LayerMap(columns, rows, texels),
                        60 + 80 * random.nextDouble(),
                        -70 + 80 * random.nextDouble());
                assertEquals(1, Arrays.stream(weights).sum(), 1e-12);
                assertTrue(Arrays.stream(weights).allMatch(weight -> weight >= 0));
            }
        }
    }

    @Test
    void nothingPaintedChangesNothingAndFullPaintLeavesNothing() {
        assertArrayEquals(MIXED, at(map(2, 2, 2, 0, 200, 0, 1, 0, 0, 0), 90, -40), 0);
        assertArrayEquals(new double[] {0, 0, 1}, at(map(2, 2, 2, 255, 2, 255, 2, 255, 2, 255), 90, -40), 1e-15);
    }

    /** Three by two texels lie 32 m apart along x and 64 m along z, and the outer ones on the border. */
    @Test
    void eachTexelGivesItsWeightToItsOwnLayer() {
        LayerMap map = map(3, 2, 0, 0, 1, 255, 2, 255, 0, 0, 1, 255, 2, 51);
        assertArrayEquals(new double[] {0, 1, 0}, at(map, 100, -62), 1e-12);
        assertArrayEquals(new double[] {0, 0, 1}, at(map, 132, -62), 1e-12);
        assertArrayEquals(new double[] {0.4, 0.2, 0.4}, at(map, 132, 2), 1e-12);
        assertArrayEquals(MIXED, at(map, 68, -30), 0);
        assertArrayEquals(new double[] {0.25, 0.625, 0.125}, at(map, 84, -30), 1e-12, "half of layer 1");
        // Halfway between all four texels of the right cell: a quarter each of b, c, b and a fifth of c.
        assertArrayEquals(new double[] {0.1, 0.55, 0.35}, at(map, 116, -30), 1e-12);
        assertArrayEquals(at(map, 132, 2), at(map, 1e6, 1e6), 0, "beside the terrain");
    }

    @Test
    void paintMovesWithItsTerrain() {
        LayerMap map = map(3, 2, 0, 0, 1, 255, 2, 255, 0, 0, 1, 255, 2, 51);
        double[] weights = MIXED.clone();
        new LayerPaint(RecordCopy.with(GROUND, "centre", new Vec3(1100, -5, 970)), map).over(1111, 955, weights);
        assertArrayEquals(at(map, 111, -45), weights, 1e-12);
    }

    @Test
    void aMapIsReadOnlyForTwoLayersOrMore() {
        byte[] file = map(2, 2, 0, 1, 0, 255, 0, 3, 9, 0).png();
        TestAssets assets = new TestAssets().file("m.png", file);
        assertEquals(Optional.empty(), LayerPaint.read(GROUND, assets));
        Terrain painted = GROUND.withLayerMap("m.png");
        assertEquals(3, LayerPaint.read(painted, assets).orElseThrow().weight(0, 1));
        Terrain one = TestTerrain.said("t", "none", Layer.everywhere("a")).withLayerMap("m.png");
        assertEquals(Optional.empty(), LayerPaint.read(one, assets));
    }

    @Test
    void aLayerThatTheTerrainLacksIsToldWithItsPixel() {
        LayerMap map = map(2, 3, 0, 1, 0, 255, 7, 0, 3, 1, 9, 9, 0, 0);
        Terrain painted = GROUND.withLayerMap("m.png");
        AssetException told = assertThrows(AssetException.class, () -> LayerPaint.requireLayers(painted, map));
        assertEquals(
                "m.png: paints layer 3 at pixel (1, 1), and 't' has layers 0 to 2; give the terrain that layer, or name"
                        + " another layerMap or none",
                told.getMessage());
        assertSame("m.png", told.assetId());
    }
}
