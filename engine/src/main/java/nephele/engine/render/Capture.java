package nephele.engine.render;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import nephele.engine.asset.AtomicFile;
import nephele.engine.render.gl.RenderTarget;

/** Writes the pictures of render targets to files. */
public final class Capture {
    private Capture() {}

    /** Returns the displayed 8-bit picture, opaque. */
    public static BufferedImage image(RenderTarget picture) {
        int width = picture.width();
        int height = picture.height();
        ByteBuffer rgba = picture.readBytes();
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        int[] row = new int[width];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int at = 4 * ((height - 1 - y) * width + x);
                row[x] = (rgba.get(at) & 0xff) << 16 | (rgba.get(at + 1) & 0xff) << 8 | rgba.get(at + 2) & 0xff;
            }
            image.setRGB(0, y, width, 1, row, 0, width);
        }
        return image;
    }

    /** Writes the 8-bit picture as PNG. */
    public static void png(RenderTarget picture, Path file) throws IOException {
        png(image(picture), file);
    }

    /** Writes another picture as PNG. */
    public static void png(BufferedImage picture, Path file) throws IOException {
        AtomicFile.write(file, encoded(picture));
    }

    /**
     * Writes linear RGB radiance as PFM: rows from the bottom, little-endian floats.
     *
     * @param rgb the bottom row first
     */
    public static void pfm(float[] rgb, int width, int height, Path file) throws IOException {
        byte[] header = ("PF\n" + width + " " + height + "\n-1.0\n").getBytes(StandardCharsets.US_ASCII);
        ByteBuffer bytes = ByteBuffer.allocate(header.length + 4 * rgb.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(header);
        bytes.asFloatBuffer().put(rgb);
        AtomicFile.write(file, bytes.array());
    }

    /** Encodes in memory: ImageIO would delete an existing file first and print a stack trace if it cannot open it. */
    private static byte[] encoded(BufferedImage image) throws IOException {
        var bytes = new ByteArrayOutputStream();
        try (var stream = new MemoryCacheImageOutputStream(bytes)) {
            if (!ImageIO.write(image, "png", stream)) {
                throw new IOException("this Java cannot write PNG");
            }
        }
        return bytes.toByteArray();
    }
}
