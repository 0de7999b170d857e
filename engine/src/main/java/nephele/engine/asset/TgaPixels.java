package nephele.engine.asset;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Decodes Truevision TGA 2.0: grey, true colour and palettes, plain or in run-length packets, from any corner. An own
 * reader, because the library's ignores the palette's first index and palettes of true-colour files, and mirrors files
 * that begin on the right.
 */
final class TgaPixels {
    private static final int HEADER_BYTES = 18;
    private static final int FOOTER_BYTES = 26;
    private static final String SIGNATURE = "TRUEVISION-XFILE.";
    private static final int PACKED = 8;
    private static final int PALETTE = 1;
    private static final int COLOUR = 2;
    private static final int GREY = 3;
    private static final int FROM_RIGHT = 0x10;
    private static final int FROM_TOP = 0x20;
    private static final int PREMULTIPLIED = 4;
    private static final int USEFUL_ALPHA = 3;

    private final ByteBuffer file;
    private final int type;
    private final boolean isPacked;
    private final int width;
    private final int height;
    private final int pixelBits;
    private final int corner;
    private final int paletteBits;
    private final int paletteBegin;
    private final int firstColour;
    private final int colours;

    /** What alpha means: 0 for none, or as in the extension area's attributes type. */
    private final int alpha;

    private TgaPixels(byte[] bytes) throws IOException {
        file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        type = bytes[2] & ~PACKED;
        isPacked = (bytes[2] & PACKED) != 0;
        width = word(12);
        height = word(14);
        pixelBits = bytes[16] & 0xff;
        corner = bytes[17];
        paletteBegin = HEADER_BYTES + (bytes[0] & 0xff);
        firstColour = word(3);
        colours = bytes[1] == 0 ? 0 : word(5);
        paletteBits = bytes[7] & 0xff;
        boolean isKnown = type == COLOUR && isColour(pixelBits)
                || type == GREY && (pixelBits == 8 || pixelBits == 16)
                || type == PALETTE && (pixelBits == 8 || pixelBits == 16) && colours > 0 && isColour(paletteBits);
        if (!isKnown) {
            throw new IOException("type " + bytes[2] + " of " + pixelBits + " bits");
        }
        alpha = (corner & 0xf) == 0 ? 0 : alphaKind();
    }

    static Picture decode(byte[] bytes) throws IOException {
        TgaPixels tga = new TgaPixels(bytes);
        try {
            return tga.picture();
        } catch (IndexOutOfBoundsException cutOff) {
            throw new IOException("cut off", cutOff);
        }
    }

    private static boolean isColour(int bits) {
        return bits == 15 || bits == 16 || bits == 24 || bits == 32;
    }

    private int word(int at) {
        return file.getShort(at) & 0xffff;
    }

    /** Returns the attributes type of the extension area, which a footer leads to; useful alpha without one. */
    private int alphaKind() {
        int footer = file.limit() - FOOTER_BYTES;
        if (footer < HEADER_BYTES || !SIGNATURE.equals(text(footer + 8, SIGNATURE.length()))) {
            return USEFUL_ALPHA;
        }
        int extension = file.getInt(footer);
        boolean isThere = extension >= HEADER_BYTES && extension <= footer - 495;
        int kind = isThere ? file.get(extension + 494) : USEFUL_ALPHA;
        return kind == USEFUL_ALPHA || kind == PREMULTIPLIED ? kind : 0;
    }

    private String text(int at, int length) {
        StringBuilder text = new StringBuilder();
        for (int i = at; i < at + length; i++) {
            text.append((char) (file.get(i) & 0xff));
        }
        return text.toString();
    }

    private Picture picture() throws IOException {
        int bits = type == PALETTE ? paletteBits : pixelBits;
        boolean hasAlpha = alpha != 0 && (bits == 32 || bits == 16);
        int channels = (type == GREY ? 1 : 3) + (hasAlpha ? 1 : 0);
        byte[] samples = new byte[width * height * channels];
        int pixelBytes = bytesOf(pixelBits);
        int at = paletteBegin + colours * bytesOf(paletteBits);
        int left = 0;
        boolean isRun = false;
        for (int pixel = 0; pixel < width * height; pixel++) {
            if (isPacked && left == 0) {
                int packet = file.get(at++);
                isRun = packet < 0;
                left = (packet & 0x7f) + 1;
                if (left > width * height - pixel) {
                    throw new IOException("a packet goes beyond the picture");
                }
            }
            left--;
            write(at, samples, place(pixel) * channels, channels);
            at += isRun && left > 0 ? 0 : pixelBytes;
        }
        return new Picture(width, height, channels, 8, samples);
    }

    /** Returns the number of a pixel of the file in the picture, whose rows begin at the top left. */
    private int place(int pixel) {
        int column = pixel % width;
        int row = pixel / width;
        int x = (corner & FROM_RIGHT) == 0 ? column : width - 1 - column;
        int y = (corner & FROM_TOP) == 0 ? height - 1 - row : row;
        return y * width + x;
    }

    private void write(int at, byte[] samples, int out, int channels) throws IOException {
        if (type == GREY) {
            for (int channel = 0; channel < channels; channel++) {
                samples[out + channel] = file.get(at + channel);
            }
            // The pixel of a file without meaningful alpha is as long as one with it.
            file.get(at + bytesOf(pixelBits) - 1);
        } else if (type == PALETTE) {
            int index = (pixelBits == 8 ? file.get(at) & 0xff : word(at)) - firstColour;
            if (index < 0 || index >= colours) {
                throw new IOException("a pixel names none of its palette's colours");
            }
            writeColour(paletteBits, paletteBegin + index * bytesOf(paletteBits), samples, out, channels);
        } else {
            writeColour(pixelBits, at, samples, out, channels);
        }
        if (alpha == PREMULTIPLIED) {
            divide(samples, out, channels);
        }
    }

    private void writeColour(int bits, int at, byte[] samples, int out, int channels) {
        if (bits < 24) {
            int packed = word(at);
            if (channels == 4) {
                samples[out + 3] = (byte) (packed >> 15 == 0 ? 0 : 255);
            }
            for (int channel = 0; channel < 3; channel++) {
                samples[out + channel] = (byte) (((packed >> 10 - 5 * channel & 31) * 255 + 15) / 31);
            }
            return;
        }
        for (int channel = 0; channel < 3; channel++) {
            samples[out + channel] = file.get(at + 2 - channel);
        }
        byte fourth = bits == 32 ? file.get(at + 3) : 0;
        if (channels == 4) {
            samples[out + 3] = fourth;
        }
    }

    private static void divide(byte[] samples, int out, int channels) {
        int fraction = samples[out + channels - 1] & 0xff;
        for (int channel = 0; channel < channels - 1 && channels % 2 == 0 && fraction > 0; channel++) {
            samples[out + channel] =
                    (byte) Math.min(255, ((samples[out + channel] & 0xff) * 255 + fraction / 2) / fraction);
        }
    }

    private static int bytesOf(int bits) {
        return (bits + 7) / 8;
    }
}
