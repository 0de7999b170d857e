package nephele.engine.level.billboard;

import java.util.Arrays;
import nephele.engine.asset.Picture;

/**
 * Gives the transparent pixels of a picture the colour of visible ones: rings of neighbours, each the mean of those that
 * the ring before has coloured. Alpha stays.
 */
final class ColourSpread {
    private static final int[] STEPS = {-1, -1, 0, -1, 1, -1, -1, 0, 1, 0, -1, 1, 0, 1, 1, 1};

    private final int width;
    private final int height;
    private final byte[] samples;
    private final int[] ringOf;
    private int[] ring;
    private int size;

    private ColourSpread(Picture picture) {
        width = picture.width();
        height = picture.height();
        samples = picture.samples().clone();
        ringOf = new int[width * height];
        ring = new int[width * height];
    }

    static Picture over(Picture picture) {
        ColourSpread spread = new ColourSpread(picture);
        spread.run();
        return new Picture(picture.width(), picture.height(), 4, 8, spread.samples);
    }

    private void run() {
        Arrays.fill(ringOf, Integer.MAX_VALUE);
        for (int i = 0; i < ringOf.length; i++) {
            if (samples[4 * i + 3] != 0) {
                ringOf[i] = 0;
                ring[size++] = i;
            }
        }
        for (int number = 1; size > 0; number++) {
            int[] next = new int[Math.min(ringOf.length, 8 * size)];
            int found = 0;
            for (int i = 0; i < size; i++) {
                found = reach(ring[i], number, next, found);
            }
            for (int i = 0; i < found; i++) {
                colour(next[i], number);
            }
            ring = next;
            size = found;
        }
    }

    private int reach(int pixel, int number, int[] next, int found) {
        int count = found;
        for (int step = 0; step < STEPS.length; step += 2) {
            int other = neighbour(pixel, step);
            if (other >= 0 && ringOf[other] == Integer.MAX_VALUE) {
                ringOf[other] = number;
                next[count++] = other;
            }
        }
        return count;
    }

    /** Returns the index of a neighbour, −1 outside. */
    private int neighbour(int pixel, int step) {
        int x = pixel % width + STEPS[step];
        int y = pixel / width + STEPS[step + 1];
        return x < 0 || y < 0 || x >= width || y >= height ? -1 : y * width + x;
    }

    private void colour(int pixel, int number) {
        int[] sum = new int[3];
        int count = 0;
        for (int step = 0; step < STEPS.length; step += 2) {
            int other = neighbour(pixel, step);
            if (other >= 0 && ringOf[other] < number) {
                for (int channel = 0; channel < 3; channel++) {
                    sum[channel] += samples[4 * other + channel] & 0xff;
                }
                count++;
            }
        }
        for (int channel = 0; channel < 3; channel++) {
            samples[4 * pixel + channel] = (byte) ((sum[channel] + count / 2) / count);
        }
    }
}
