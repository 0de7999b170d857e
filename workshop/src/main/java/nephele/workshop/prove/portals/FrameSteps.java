package nephele.workshop.prove.portals;

import java.nio.ByteBuffer;
import java.util.Arrays;

/** Measures the difference of two 8-bit pictures of one size. */
final class FrameSteps {
    private static final double PERCENTILE = 0.999;
    /** The difference in codes that dithering and rounding cause on one surface. */
    private static final int SAME_CODES = 2;

    private FrameSteps() {}

    /**
     * The difference of two pictures.
     *
     * @param mean codes a channel
     * @param most code that 999 of 1000 channels do not exceed
     */
    record Step(double mean, int most) {
        static final Step NONE = new Step(0, 0);

        /** Returns the greater of both, for each number. */
        Step or(Step other) {
            return new Step(Math.max(mean, other.mean), Math.max(most, other.most));
        }
    }

    /** @param a RGBA; alpha does not count */
    static Step between(byte[] a, byte[] b) {
        int[] counts = new int[256];
        long sum = 0;
        for (int i = 0; i < a.length; i++) {
            if (i % 4 != 3) {
                int difference = Math.abs((a[i] & 0xff) - (b[i] & 0xff));
                counts[difference]++;
                sum += difference;
            }
        }
        int channels = Arrays.stream(counts).sum();
        int left = (int) Math.floor(channels * (1 - PERCENTILE));
        int most = 255;
        while (most > 0 && left >= counts[most]) {
            left -= counts[most--];
        }
        return new Step((double) sum / channels, most);
    }

    /**
     * Returns the number of pixels that differ although they are more than one pixel from every edge of both pictures,
     * which rounding does not explain.
     */
    static int strangers(byte[] a, byte[] b, int width) {
        int height = a.length / 4 / width;
        int count = 0;
        for (int y = 1; y < height - 1; y++) {
            for (int x = 1; x < width - 1; x++) {
                int at = 4 * (y * width + x);
                count += !areAlike(a, at, b, at) && isEven(a, at, width) && isEven(b, at, width) ? 1 : 0;
            }
        }
        return count;
    }

    private static boolean isEven(byte[] picture, int at, int width) {
        for (int row = -1; row <= 1; row++) {
            for (int column = -1; column <= 1; column++) {
                if (!areAlike(picture, at, picture, at + 4 * (row * width + column))) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean areAlike(byte[] a, int i, byte[] b, int j) {
        for (int channel = 0; channel < 3; channel++) {
            if (Math.abs((a[i + channel] & 0xff) - (b[j + channel] & 0xff)) > SAME_CODES) {
                return false;
            }
        }
        return true;
    }

    static byte[] bytes(ByteBuffer rgba) {
        byte[] copy = new byte[rgba.remaining()];
        rgba.get(copy);
        return copy;
    }
}
