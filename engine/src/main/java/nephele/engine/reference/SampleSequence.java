package nephele.engine.reference;

import java.util.SplittableRandom;
import nephele.engine.math.Hash64;
import nephele.engine.math.SeededNoise;

/**
 * Low-discrepancy points of the unit square: Roberts' R2 sequence ("The Unreasonable Effectiveness of Quasirandom
 * Sequences", 2018), shifted for each pixel and use by its own offset (Cranley and Patterson 1976). A pure function of
 * pixel, use, index and seed.
 */
final class SampleSequence {
    /** The positive root of x³ = x + 1; its powers are the least rational steps in two dimensions. */
    private static final double STEP_ROOT = 1.32471795724474602596;

    /** Tells the seeds of random streams from that of the points. */
    private static final long STREAMS = 1;

    /** Coordinates of the noise that shifts the points of a pixel's square, and those of its rays to the sky. */
    private static final int PIXEL = 0;

    private static final int SKY = 2;

    /**
     * A point of the unit square.
     *
     * @param x in [0, 1), as is {@code y}
     */
    record Point(double x, double y) {}

    /** One of the samples of a pixel. */
    final class PixelSample {
        private final int column;
        private final int row;
        private final int index;
        private SplittableRandom random;

        private PixelSample(int column, int row, int index) {
            this.column = column;
            this.row = row;
            this.index = index;
        }

        /** Returns the position in its pixel. */
        Point inPixel() {
            return point(PIXEL, column, row, index);
        }

        /**
         * Returns the point for a ray to the sky.
         *
         * @param ray less than {@link Illumination#SKY_RAYS}
         */
        Point sky(int ray) {
            return point(SKY, column, row, index * Illumination.SKY_RAYS + ray);
        }

        /** Returns the sample's own random numbers, for random walks through clouds. */
        SplittableRandom random() {
            if (random == null) {
                long pixel = Hash64.combine(Hash64.combine(stream, column), row);
                random = new SplittableRandom(Hash64.combine(pixel, index));
            }
            return random;
        }
    }

    private final SeededNoise noise;
    private final long stream;

    SampleSequence(long seed) {
        stream = Hash64.combine(STREAMS, seed);
        noise = new SeededNoise((int) Hash64.combine(0, seed));
    }

    PixelSample sample(int column, int row, int index) {
        return new PixelSample(column, row, index);
    }

    private Point point(int use, int column, int row, int index) {
        double x = noise.unit(column, row, use) + (index + 1) / STEP_ROOT;
        double y = noise.unit(column, row, use + 1) + (index + 1) / (STEP_ROOT * STEP_ROOT);
        return new Point(x - Math.floor(x), y - Math.floor(y));
    }
}
