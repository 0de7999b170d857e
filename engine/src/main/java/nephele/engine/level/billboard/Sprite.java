package nephele.engine.level.billboard;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Billboards;
import nephele.engine.math.Vec3;

/**
 * The pictures of a group's billboards as 8-bit RGBA with straight alpha. Transparent pixels have the colours of the
 * nearest visible ones, so that filtering draws no fringe of the colour key.
 *
 * @param frames of equal size
 */
public record Sprite(int width, int height, List<Picture> frames) {
    public Sprite {
        frames = List.copyOf(frames);
    }

    /**
     * Reads a group's picture.
     *
     * @throws nephele.engine.asset.AssetException that names a picture that cannot be used
     */
    public static Sprite of(Billboards group, AssetSource assets) {
        return PictureDecoder.inMemory(group.sprite(), () -> read(group, assets));
    }

    private static Sprite read(Billboards group, AssetSource assets) {
        Picture stored = PictureDecoder.decode(group.sprite(), assets.bytes(group.sprite()));
        boolean hasAlpha = stored.channels() == 2 || stored.channels() == 4;
        Picture keyed = stored.toRgba8();
        Vec3 key = group.colourKey() == null && !hasAlpha ? Vec3.ZERO : group.colourKey();
        if (key != null) {
            keyed = keyed(keyed, key);
        }
        // A picture of another width has been reported; its rest is left out here.
        int width = Math.max(1, keyed.width() / group.frames());
        List<Picture> frames = new ArrayList<>();
        for (int i = 0; i < Math.min(group.frames(), keyed.width()); i++) {
            frames.add(ColourSpread.over(cut(keyed, i * width, width)));
        }
        return new Sprite(width, keyed.height(), frames);
    }

    private static Picture keyed(Picture picture, Vec3 key) {
        byte[] samples = picture.samples().clone();
        byte red = code(key.x());
        byte green = code(key.y());
        byte blue = code(key.z());
        for (int i = 0; i < samples.length; i += 4) {
            if (samples[i] == red && samples[i + 1] == green && samples[i + 2] == blue) {
                samples[i + 3] = 0;
            }
        }
        return new Picture(picture.width(), picture.height(), 4, 8, samples);
    }

    private static byte code(double value) {
        return (byte) Math.round(255 * value);
    }

    private static Picture cut(Picture picture, int left, int width) {
        byte[] samples = new byte[4 * width * picture.height()];
        for (int y = 0; y < picture.height(); y++) {
            System.arraycopy(picture.samples(), 4 * (y * picture.width() + left), samples, 4 * y * width, 4 * width);
        }
        return new Picture(width, picture.height(), 4, 8, samples);
    }

    /**
     * Gives the transparent pixels of a picture the colour of visible ones: rings of neighbours, each the mean of those that
     * the ring before has coloured. Alpha stays.
     */
    private static final class ColourSpread {
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
}
