package nephele.engine.asset;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Locale;
import nephele.engine.work.SwingThread;

/**
 * Heights as a file stores them, brought to 16 bits: 0 is the least, 65535 the greatest value of any file. Files are
 * grey PNG, TGA or BMP pictures of 8 or 16 bits, the mean of the channels of others, or raw 16-bit numbers,
 * little-endian and square, in files that end with {@code .r16}. Sizes are checked before samples are decoded.
 *
 * @param bits of the file's values, 8 or 16
 * @param values rows from the top, samples from the left; unsigned
 */
public record HeightMap(int columns, int rows, int bits, short[] values) {
    private static final String RAW = ".r16";

    /** The factor from 8 to 16 bits that takes full scale to full scale. */
    private static final int SIXTEEN_OF_EIGHT_BITS = 257;

    /** The greatest value. */
    public static final int FULL_SCALE = 65535;

    /** The most samples along a side. */
    public static final int MOST_SAMPLES = 8193;

    /** The least samples along a side. */
    public static final int LEAST_SAMPLES = 2;

    /** The least ratio of a map's roughness to that with exchanged bytes from which its bytes count as exchanged. */
    private static final double ROUGHER = 4;

    /** Fewer samples along a side tell nothing. */
    private static final int LEAST_JUDGED = 8;

    /** About as many samples are looked at. */
    private static final int LOOKED_AT = 1 << 20;

    /**
     * Returns true if the bytes of each value seem to be exchanged: the step from sample to sample, as a share of the
     * range, would be far smaller if they were. Noise, steps of 256 and values of 8 bits are equal either way.
     */
    public boolean seemsSwapped() {
        return bits == 16 && Math.min(columns, rows) >= LEAST_JUDGED && roughness(false) > ROUGHER * roughness(true);
    }

    /** Returns the mean step between neighbours as a share of the range; 0 for a plane. */
    private double roughness(boolean isSwapped) {
        int stride = Math.max(1, values.length / LOOKED_AT);
        int least = FULL_SCALE;
        int most = 0;
        double steps = 0;
        long count = 0;
        for (int row = 0; row + 1 < rows; row += stride) {
            for (int column = 0; column + 1 < columns; column++) {
                int at = row * columns + column;
                int value = value(at, isSwapped);
                least = Math.min(least, value);
                most = Math.max(most, value);
                steps += Math.abs(value - value(at + 1, isSwapped)) + Math.abs(value - value(at + columns, isSwapped));
                count += 2;
            }
        }
        return most == least ? 0 : steps / count / (most - least);
    }

    private int value(int at, boolean isSwapped) {
        return (isSwapped ? Short.reverseBytes(values[at]) : values[at]) & 0xffff;
    }

    /** Returns a value, 0 to {@link #FULL_SCALE}. */
    public int value(int column, int row) {
        return values[row * columns + column] & 0xffff;
    }

    /**
     * Returns the heights of a file.
     *
     * @param assetId names the file in errors; raw files are recognised by its extension
     * @throws AssetException if the file is of an unknown kind, damaged, too small or too large
     */
    public static HeightMap read(String assetId, byte[] bytes) throws AssetException {
        SwingThread.refuse("reading a height map");
        try {
            return isRaw(assetId) ? raw(assetId, bytes) : picture(assetId, bytes);
        } catch (OutOfMemoryError tooLarge) {
            throw new AssetException(assetId, "does not fit into memory", "make the height map smaller");
        }
    }

    /** Returns true if the file holds numbers alone, as its extension says. */
    public static boolean isRaw(String assetId) {
        return assetId.toLowerCase(Locale.ROOT).endsWith(RAW);
    }

    /** Returns a file of the heights: a grey PNG of 16 bits, which reads back as the same values. */
    public byte[] png() {
        ByteBuffer samples = ByteBuffer.allocate(2 * values.length);
        samples.asShortBuffer().put(values);
        return PngEncoder.file(new PngFile.Header(columns, rows, 16, 0, 0), samples.array());
    }

    private static HeightMap raw(String assetId, byte[] bytes) {
        PictureFormat format = PictureFormat.of(assetId, bytes);
        if (format != null) {
            throw new AssetException(
                    assetId,
                    "is a " + format + " picture, not raw 16-bit heights",
                    "rename it to ." + format.name().toLowerCase(Locale.ROOT));
        }
        int side = root(bytes.length / 2);
        if (bytes.length % 2 != 0 || side * (long) side * 2 != bytes.length) {
            int byteSide = root(bytes.length);
            boolean hasEightBits = byteSide * (long) byteSide == bytes.length && byteSide > 1;
            throw new AssetException(
                    assetId,
                    "has " + bytes.length + " bytes, which is not 2 x n x n"
                            + (hasEightBits ? ": it looks like 8-bit heights of " + byteSide + " x " + byteSide : ""),
                    "write a square of 16-bit heights, low byte first");
        }
        requireSize(assetId, side, side);
        short[] values = new short[side * side];
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().get(values);
        return new HeightMap(side, side, 16, values);
    }

    private static int root(int number) {
        return (int) Math.round(Math.sqrt(number));
    }

    private static HeightMap picture(String assetId, byte[] bytes) {
        PictureFormat format = PictureFormat.of(assetId, bytes);
        if (format == null || format == PictureFormat.JPEG) {
            throw new AssetException(
                    assetId,
                    format == null ? "is no height map" : "is a JPEG picture, whose compression changes heights",
                    "use a grey PNG of 16 bits, a TGA, a BMP, or raw 16-bit heights named .r16");
        }
        PictureFormat.Size size = format.size(bytes);
        if (size != null) {
            requireSize(assetId, size.width(), size.height());
        }
        Picture picture = PictureDecoder.decode(assetId, bytes, PictureDecoder.Limits.HEIGHTS);
        return new HeightMap(picture.width(), picture.height(), picture.bitsPerChannel(), values(picture));
    }

    private static void requireSize(String assetId, long columns, long rows) {
        if (Math.min(columns, rows) < LEAST_SAMPLES || Math.max(columns, rows) > MOST_SAMPLES) {
            throw new AssetException(
                    assetId,
                    "has " + columns + " x " + rows + " samples",
                    "a height map has " + LEAST_SAMPLES + " to " + MOST_SAMPLES + " along each side: scale it");
        }
    }

    private static short[] values(Picture picture) {
        short[] values = new short[picture.width() * picture.height()];
        byte[] from = picture.samples();
        int channels = picture.channels();
        boolean isGrey = channels < 3;
        boolean isWide = picture.bitsPerChannel() == 16;
        int stride = channels * picture.bitsPerChannel() / 8;
        for (int i = 0, at = 0; i < values.length; i++, at += stride) {
            int sum = 0;
            int next = at;
            for (int channel = 0; channel < (isGrey ? 1 : 3); channel++) {
                sum += isWide
                        ? from[next++] & 0xff | (from[next++] & 0xff) << 8
                        : (from[next++] & 0xff) * SIXTEEN_OF_EIGHT_BITS;
            }
            values[i] = (short) (isGrey ? sum : (sum + 1) / 3);
        }
        return values;
    }
}
