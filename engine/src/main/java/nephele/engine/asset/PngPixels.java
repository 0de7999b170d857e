package nephele.engine.asset;

import java.io.IOException;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/**
 * Decodes non-interlaced PNG of 8 or 16 bits, the kinds that levels use. Its twin {@link ImageIoPictures} decodes the
 * rest, but costs a start of java.desktop (about 70 ms and 180 classes) that this class avoids.
 */
final class PngPixels {
    private final PngFile file;
    private final Inflater inflater = new Inflater();
    private int nextSpan;

    private PngPixels(PngFile file) {
        this.file = file;
    }

    static boolean canDecode(PngFile file) {
        PngFile.Header header = file.header();
        boolean colours = header.colour() == 0 || header.colour() == 2 || header.colour() == 4 || header.colour() == 6;
        boolean depth = header.bitDepth() == 8 || header.bitDepth() == 16;
        return colours && depth && header.interlace() == 0 && !file.hasTransparency();
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
        PngFile.Header header = file.header();
        int pixelBytes = header.channels() * header.bitDepth() / 8;
        int rowBytes = header.width() * pixelBytes;
        byte[] samples = new byte[rowBytes * header.height()];
        byte[] filter = new byte[1];
        for (int y = 0, row = 0; y < header.height(); y++, row += rowBytes) {
            inflate(filter, 0, 1);
            inflate(samples, row, rowBytes);
            unfilter(filter[0], samples, row, y == 0, rowBytes, pixelBytes);
        }
        if (header.bitDepth() == 16) {
            lowByteFirst(samples);
        }
        return new Picture(header.width(), header.height(), header.channels(), header.bitDepth(), samples);
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
        PngFile.Span span = file.pixelData().get(nextSpan++);
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
}
