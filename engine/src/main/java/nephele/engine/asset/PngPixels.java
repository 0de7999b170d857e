package nephele.engine.asset;

import java.io.IOException;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/**
 * Decodes all kinds of PNG. Its twin {@link ImageIoPictures} drops some keys of transparency, and costs a start of
 * java.desktop (about 70 ms and 180 classes).
 */
final class PngPixels {
    static final int PALETTE = 3;

    /** First column and row, and steps between columns and rows, of each pass (section 8.2). */
    private static final int[][] ADAM_7 = {
        {0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}
    };

    private static final int[][] WHOLE = {{0, 0, 1, 1}};

    private final PngFile file;
    private final PngFile.Header header;
    private final byte[] palette;

    /** Alpha of the palette's first colours, or the key: the numbers of the one transparent colour. */
    private final byte[] transparency;

    private final int channels;
    private final int outBits;
    private final Inflater inflater = new Inflater();
    private int nextSpan;

    private PngPixels(PngFile file) throws IOException {
        this.file = file;
        header = file.header();
        requireKnown(header);
        boolean isPalette = header.colour() == PALETTE;
        palette = isPalette ? content(file, file.palette()) : new byte[0];
        transparency = content(file, file.transparency());
        boolean isFit = isPalette
                ? palette.length % 3 == 0 && transparency.length <= palette.length / 3
                : transparency.length == 0
                        || (header.colour() == 0 || header.colour() == 2)
                                && transparency.length == 2 * header.channels();
        if (!isFit) {
            throw new IOException("a palette or transparency that does not fit the pixels");
        }
        channels = (isPalette ? 3 : header.channels()) + (transparency.length > 0 ? 1 : 0);
        outBits = Math.max(8, header.bitDepth());
    }

    static Picture decode(PngFile file) throws IOException {
        PngPixels pixels = new PngPixels(file);
        try {
            return pixels.picture();
        } catch (DataFormatException problem) {
            throw new IOException(problem);
        } finally {
            pixels.inflater.end();
        }
    }

    private Picture picture() throws IOException, DataFormatException {
        boolean isPlain = header.interlace() == 0
                && header.bitDepth() >= 8
                && header.colour() != PALETTE
                && transparency.length == 0;
        return new Picture(header.width(), header.height(), channels, outBits, isPlain ? plain() : expanded());
    }

    private byte[] plain() throws IOException, DataFormatException {
        byte[] samples = pass(header.width(), header.height());
        if (header.bitDepth() == 16) {
            lowByteFirst(samples);
        }
        return samples;
    }

    /**
     * Expands packed pixels (third edition, sections 4.5, 7.2 and 11.3.1.1): palettes to their colours, keys of
     * transparency to alpha, less than 8 bits to 8.
     */
    private byte[] expanded() throws IOException, DataFormatException {
        byte[] samples = new byte[header.width() * header.height() * channels * outBits / 8];
        for (int[] pass : header.interlace() == 0 ? WHOLE : ADAM_7) {
            int columns = (header.width() - pass[0] + pass[2] - 1) / pass[2];
            int rows = (header.height() - pass[1] + pass[3] - 1) / pass[3];
            if (columns > 0 && rows > 0) {
                expand(pass(columns, rows), columns, rows, pass, samples);
            }
        }
        return samples;
    }

    /** Refuses what the specification's table 11.1 does not list. */
    private static void requireKnown(PngFile.Header header) throws IOException {
        int depth = header.bitDepth();
        boolean isKnown =
                switch (header.colour()) {
                    case 0 -> depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16;
                    case PALETTE -> depth == 1 || depth == 2 || depth == 4 || depth == 8;
                    case 2, 4, 6 -> depth == 8 || depth == 16;
                    default -> false;
                };
        if (!isKnown || header.interlace() < 0 || header.interlace() > 1) {
            throw new IOException("unknown colours, depth or interlacing");
        }
    }

    /** Returns the unfiltered rows of a pass. */
    private byte[] pass(int columns, int rows) throws IOException, DataFormatException {
        int pixelBits = header.channels() * header.bitDepth();
        int rowBytes = (columns * pixelBits + 7) / 8;
        byte[] packed = new byte[rowBytes * rows];
        byte[] filter = new byte[1];
        for (int y = 0, row = 0; y < rows; y++, row += rowBytes) {
            inflate(filter, 0, 1);
            inflate(packed, row, rowBytes);
            unfilter(filter[0], packed, row, y == 0, rowBytes, Math.max(1, pixelBits / 8));
        }
        return packed;
    }

    private void inflate(byte[] into, int offset, int length) throws IOException, DataFormatException {
        int done = 0;
        while (done < length) {
            int now = inflater.inflate(into, offset + done, length - done);
            done += now;
            if (now == 0) {
                feed();
            }
        }
    }

    private void feed() throws IOException {
        if (!inflater.needsInput() || nextSpan == file.pixelData().size()) {
            throw new IOException("too few pixels");
        }
        PictureFormat.Span span = file.pixelData().get(nextSpan++);
        inflater.setInput(file.bytes(), span.offset(), span.length());
    }

    /**
     * Undoes a row's filter in place (section 9.2). The row above is already unfiltered; above the first it counts as
     * 0.
     */
    private static void unfilter(byte filter, byte[] s, int row, boolean first, int rowBytes, int pixelBytes)
            throws IOException {
        switch (filter) {
            case 0 -> {}
            case 1 -> left(s, row, rowBytes, pixelBytes);
            case 2 -> {
                if (!first) {
                    up(s, row, rowBytes);
                }
            }
            case 3 -> average(s, row, first, rowBytes, pixelBytes);
            case 4 -> {
                if (first) {
                    left(s, row, rowBytes, pixelBytes);
                } else {
                    paeth(s, row, rowBytes, pixelBytes);
                }
            }
            default -> throw new IOException("unknown filter");
        }
    }

    private static void left(byte[] s, int row, int rowBytes, int pixelBytes) {
        for (int i = row + pixelBytes; i < row + rowBytes; i++) {
            s[i] += s[i - pixelBytes];
        }
    }

    private static void up(byte[] s, int row, int rowBytes) {
        for (int i = row; i < row + rowBytes; i++) {
            s[i] += s[i - rowBytes];
        }
    }

    private static void average(byte[] s, int row, boolean first, int rowBytes, int pixelBytes) {
        for (int i = row; i < row + rowBytes; i++) {
            int a = i - row < pixelBytes ? 0 : s[i - pixelBytes] & 0xff;
            int b = first ? 0 : s[i - rowBytes] & 0xff;
            s[i] += (byte) (a + b >> 1);
        }
    }

    /** Applies the Paeth filter of section 9.4: adds the neighbour nearest to left + up − upper left. */
    private static void paeth(byte[] s, int row, int rowBytes, int pixelBytes) {
        for (int i = row; i < row + pixelBytes; i++) {
            s[i] += s[i - rowBytes];
        }
        for (int i = row + pixelBytes; i < row + rowBytes; i++) {
            int a = s[i - pixelBytes] & 0xff;
            int b = s[i - rowBytes] & 0xff;
            int c = s[i - rowBytes - pixelBytes] & 0xff;
            int toA = Math.abs(b - c);
            int toB = Math.abs(a - c);
            int toC = Math.abs(a + b - 2 * c);
            s[i] += (byte) (toA <= toB && toA <= toC ? a : toB <= toC ? b : c);
        }
    }

    private static void lowByteFirst(byte[] samples) {
        for (int i = 0; i < samples.length; i += 2) {
            byte high = samples[i];
            samples[i] = samples[i + 1];
            samples[i + 1] = high;
        }
    }

    private static byte[] content(PngFile file, PictureFormat.Span span) {
        return span == null
                ? new byte[0]
                : Arrays.copyOfRange(file.bytes(), span.offset(), span.offset() + span.length());
    }

    /** @param pass first column and row, and steps between columns and rows */
    private void expand(byte[] packed, int columns, int rows, int[] pass, byte[] samples) throws IOException {
        int rowBits = (columns * header.channels() * header.bitDepth() + 7) / 8 * 8;
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                long first = (long) y * rowBits + (long) x * header.channels() * header.bitDepth();
                int pixel = (pass[1] + y * pass[3]) * header.width() + pass[0] + x * pass[2];
                if (header.colour() == PALETTE) {
                    addColour(number(packed, first), samples, pixel * channels);
                } else {
                    addNumbers(packed, first, samples, pixel * channels);
                }
            }
        }
    }

    private void addColour(int index, byte[] samples, int out) throws IOException {
        if (3 * index >= palette.length) {
            throw new IOException("a pixel names none of its palette's colours");
        }
        System.arraycopy(palette, 3 * index, samples, out, 3);
        if (channels == 4) {
            samples[out + 3] = index < transparency.length ? transparency[index] : -1;
        }
    }

    private void addNumbers(byte[] packed, long first, byte[] samples, int out) {
        int most = (1 << header.bitDepth()) - 1;
        boolean isKey = transparency.length > 0;
        for (int channel = 0; channel < header.channels(); channel++) {
            int number = number(packed, first + (long) channel * header.bitDepth());
            write(samples, out + channel, header.bitDepth() < 8 ? number * 255 / most : number);
            isKey &= transparency.length > 0
                    && number == ((transparency[2 * channel] & 0xff) << 8 | transparency[2 * channel + 1] & 0xff);
        }
        if (channels > header.channels()) {
            write(samples, out + header.channels(), isKey ? 0 : 65_535);
        }
    }

    private void write(byte[] samples, int at, int value) {
        if (outBits == 8) {
            samples[at] = (byte) value;
        } else {
            samples[2 * at] = (byte) value;
            samples[2 * at + 1] = (byte) (value >> 8);
        }
    }

    private int number(byte[] packed, long bit) {
        int at = (int) (bit >> 3);
        int depth = header.bitDepth();
        if (depth == 16) {
            return (packed[at] & 0xff) << 8 | packed[at + 1] & 0xff;
        }
        return (packed[at] & 0xff) >> 8 - depth - (int) (bit & 7) & (1 << depth) - 1;
    }
}
