package nephele.lab.technique;

import nephele.engine.measure.LinearPicture;

/**
 * The exact picture of a sky in blocks of pixels, in two halves of independent noise, and the blocks that count: those with
 * an optical depth above 0.01 in at least half of their pixels.
 *
 * @param first a pixel a block, bottom row first
 * @param cloudy for each block whether it counts
 */
public record TracedSky(LinearPicture first, LinearPicture second, boolean[] cloudy) {
    /** Pixels along each side of a block. */
    private static final int BLOCK = 4;

    static final int WIDTH = SkyView.WIDTH / BLOCK;
    static final int HEIGHT = SkyView.HEIGHT / BLOCK;

    static TracedSky of(SkyView sky, int samples) {
        return new TracedSky(
                sky.traced(samples / 2, 1).reduced(BLOCK),
                sky.traced(samples / 2, 2).reduced(BLOCK),
                blocks(sky.cloudy()));
    }

    private static boolean[] blocks(boolean[] pixels) {
        int[] counts = new int[pixels.length / (BLOCK * BLOCK)];
        for (int pixel = 0; pixel < pixels.length; pixel++) {
            int block = pixel % SkyView.WIDTH / BLOCK + WIDTH * (pixel / SkyView.WIDTH / BLOCK);
            counts[block] += pixels[pixel] ? 1 : 0;
        }
        boolean[] blocks = new boolean[counts.length];
        for (int block = 0; block < blocks.length; block++) {
            blocks[block] = 2 * counts[block] >= BLOCK * BLOCK;
        }
        return blocks;
    }

    /** Returns the number of blocks that count. */
    public int size() {
        int count = 0;
        for (boolean one : cloudy) {
            count += one ? 1 : 0;
        }
        return count;
    }

    /** Returns the mean radiance over the blocks that count. */
    double mean() {
        double sum = 0;
        for (int i = 0; i < first.rgb().length; i++) {
            sum += cloudy[i / 3] ? (first.rgb()[i] + second.rgb()[i]) / 2 : 0;
        }
        return sum / (3 * size());
    }

    /**
     * Returns the root mean square of a picture's error over the blocks that count, in per cent of the mean radiance there.
     * The product of the differences from both halves has the expectation of the squared error: their noise cancels.
     *
     * @param drawn a pixel a pixel of the traced pictures
     */
    public double errorPercent(LinearPicture drawn) {
        float[] test = drawn.reduced(BLOCK).rgb();
        double sum = 0;
        for (int i = 0; i < test.length; i++) {
            if (cloudy[i / 3]) {
                sum += (test[i] - first.rgb()[i]) * (double) (test[i] - second.rgb()[i]);
            }
        }
        return 100 * Math.sqrt(Math.max(0, sum / (3 * size()))) / mean();
    }

    /** Returns by how much a picture's mean radiance is off, in per cent. */
    public double biasPercent(LinearPicture drawn) {
        float[] test = drawn.reduced(BLOCK).rgb();
        double sum = 0;
        for (int i = 0; i < test.length; i++) {
            sum += cloudy[i / 3] ? test[i] : 0;
        }
        return 100 * (sum / (3 * size()) / mean() - 1);
    }
}
