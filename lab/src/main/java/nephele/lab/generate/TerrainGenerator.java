package nephele.lab.generate;

import nephele.engine.asset.HeightMap;
import nephele.engine.math.SeededNoise;

/**
 * Heights of hills, ridges and valleys. Octaves of noise are damped where those before are steep, which leaves smooth
 * valleys and rough slopes (Quilez 2008, "Value noise derivatives"); ridges run where a second noise passes its middle.
 * Places are shifted by noise, so that nothing follows the lattice. All in exact arithmetic and square roots, so a seed
 * gives the same bits everywhere.
 */
public final class TerrainGenerator {
    /** Hills of the coarsest octave along a side. */
    private static final double HILLS = 3.2;

    private static final int OCTAVES = 9;
    private static final double LACUNARITY = 1.97;
    private static final double GAIN = 0.47;
    private static final double WARP = 0.55;
    private static final double DAMPING = 0.9;

    /** Turns each octave against the one before, by the angle whose cosine is 0.8. */
    private static final double COSINE = 0.8;

    private static final double SINE = 0.6;

    private final SeededNoise noise;

    private TerrainGenerator(int seed) {
        noise = new SeededNoise(seed);
    }

    /**
     * Returns heights of 0 to 1, row by row.
     *
     * @param side samples along a side, at least 2
     */
    public static float[] heights(int seed, int side) {
        TerrainGenerator painter = new TerrainGenerator(seed);
        float[] heights = new float[side * side];
        java.util.stream.IntStream.range(0, side).parallel().forEach(row -> {
            for (int column = 0; column < side; column++) {
                double x = HILLS * column / (side - 1);
                double z = HILLS * row / (side - 1);
                heights[row * side + column] = (float) painter.height(x, z);
            }
        });
        Erosion.erode(heights, side, seed);
        stretch(heights);
        return heights;
    }

    private double height(double x, double z) {
        double u = x + WARP * (noise.at(1.3 * x, 1.3 * z, 11.5) - 0.5);
        double v = z + WARP * (noise.at(1.3 * x + 40, 1.3 * z, 23.5) - 0.5);
        double hills = hills(u, v);
        double ridge = 1 - Math.abs(2 * noise.at(0.9 * u + 7, 0.9 * v, 31.5) - 1);
        double fine = 1 - Math.abs(2 * noise.at(2.1 * u + 3, 2.1 * v + 9, 37.5) - 1);
        double crest = ridge * ridge * (0.75 + 0.25 * fine);
        return 0.62 * hills + 0.38 * crest * hills;
    }

    private double hills(double x, double z) {
        double sum = 0;
        double amplitude = 1;
        double all = 0;
        double slopeX = 0;
        double slopeZ = 0;
        double step = 1e-3;
        for (int octave = 0; octave < OCTAVES; octave++) {
            double layer = 0.5 + 3 * octave;
            double here = noise.at(x, z, layer);
            slopeX += amplitude * (noise.at(x + step, z, layer) - here) / step;
            slopeZ += amplitude * (noise.at(x, z + step, layer) - here) / step;
            sum += amplitude * here / (1 + DAMPING * (slopeX * slopeX + slopeZ * slopeZ));
            all += amplitude;
            amplitude *= GAIN;
            double turned = LACUNARITY * (COSINE * x - SINE * z);
            z = LACUNARITY * (SINE * x + COSINE * z) + 17.3;
            x = turned + 5.1;
        }
        return sum / all;
    }

    private static void stretch(float[] heights) {
        float least = Float.POSITIVE_INFINITY;
        float greatest = Float.NEGATIVE_INFINITY;
        for (float height : heights) {
            least = Math.min(least, height);
            greatest = Math.max(greatest, height);
        }
        float range = Math.max(greatest - least, Float.MIN_NORMAL);
        for (int i = 0; i < heights.length; i++) {
            heights[i] = (heights[i] - least) / range;
        }
    }

    /**
     * Returns the file of square heights.
     *
     * @param heights 0 to 1, row by row
     */
    public static byte[] png(float[] heights, int side) {
        short[] values = new short[side * side];
        for (int i = 0; i < values.length; i++) {
            values[i] = (short) Math.round(HeightMap.FULL_SCALE * Math.max(0, Math.min(1, heights[i])));
        }
        return new HeightMap(side, side, 16, values).png();
    }
}
