package nephele.engine.asset;

import java.io.IOException;

/**
 * Expands the packed pixels of a PNG file (third edition, sections 4.5, 7.2 and 11.3.1.1): palettes to their colours, keys
 * of transparency to alpha, less than 8 bits to 8.
 */
final class PngExpansion {
    private final PngFile.Header header;
    private final byte[] palette;

    /** Alpha of the palette's first colours, or the key: the numbers of the one transparent colour. */
    private final byte[] transparency;

    private final int channels;
    private final int outBits;
    private final byte[] samples;

    private PngExpansion(PngFile.Header header, byte[] palette, byte[] transparency) {
        this.header = header;
        this.palette = palette;
        this.transparency = transparency;
        int colours = header.colour() == PngPixels.PALETTE ? 3 : header.channels();
        this.channels = colours + (transparency.length > 0 ? 1 : 0);
        this.outBits = Math.max(8, header.bitDepth());
        this.samples = new byte[header.width() * header.height() * channels * outBits / 8];
    }

    static PngExpansion of(PngFile file) throws IOException {
        PngFile.Header header = file.header();
        boolean isPalette = header.colour() == PngPixels.PALETTE;
        byte[] palette = isPalette ? content(file, file.palette()) : new byte[0];
        byte[] transparency = content(file, file.transparency());
        boolean isFit = isPalette
                ? palette.length % 3 == 0 && transparency.length <= palette.length / 3
                : transparency.length == 0
                        || (header.colour() == 0 || header.colour() == 2)
                                && transparency.length == 2 * header.channels();
        if (!isFit) {
            throw new IOException("a palette or transparency that does not fit the pixels");
        }
        return new PngExpansion(header, palette, transparency);
    }

    private static byte[] content(PngFile file, PngFile.Span span) {
        return span == null
                ? new byte[0]
                : java.util.Arrays.copyOfRange(file.bytes(), span.offset(), span.offset() + span.length());
    }

    Picture picture() {
        return new Picture(header.width(), header.height(), channels, outBits, samples);
    }

    /** @param pass first column and row, and steps between columns and rows */
    void add(byte[] packed, int columns, int rows, int[] pass) throws IOException {
        int rowBits = (columns * header.channels() * header.bitDepth() + 7) / 8 * 8;
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                long first = (long) y * rowBits + (long) x * header.channels() * header.bitDepth();
                int pixel = (pass[1] + y * pass[3]) * header.width() + pass[0] + x * pass[2];
                if (header.colour() == PngPixels.PALETTE) {
                    addColour(number(packed, first), pixel * channels);
                } else {
                    addNumbers(packed, first, pixel * channels);
                }
            }
        }
    }

    private void addColour(int index, int out) throws IOException {
        if (3 * index >= palette.length) {
            throw new IOException("a pixel names none of its palette's colours");
        }
        System.arraycopy(palette, 3 * index, samples, out, 3);
        if (channels == 4) {
            samples[out + 3] = index < transparency.length ? transparency[index] : -1;
        }
    }

    private void addNumbers(byte[] packed, long first, int out) {
        int most = (1 << header.bitDepth()) - 1;
        boolean isKey = transparency.length > 0;
        for (int channel = 0; channel < header.channels(); channel++) {
            int number = number(packed, first + (long) channel * header.bitDepth());
            write(out + channel, header.bitDepth() < 8 ? number * 255 / most : number);
            isKey &= transparency.length > 0
                    && number == ((transparency[2 * channel] & 0xff) << 8 | transparency[2 * channel + 1] & 0xff);
        }
        if (channels > header.channels()) {
            write(out + header.channels(), isKey ? 0 : 65_535);
        }
    }

    private void write(int at, int value) {
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
