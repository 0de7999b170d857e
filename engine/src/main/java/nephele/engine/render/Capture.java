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
import nephele.engine.level.Environment;
import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.render.gl.RenderTarget;

/** The pictures of render targets and of linear radiance as images and files. */
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

    /**
     * Returns the picture that the engine displays for linear radiance; exposure auto is metered from it.
     *
     * @param rgb linear radiance, the bottom row first
     */
    public static BufferedImage toneMapped(float[] rgb, int width, Environment environment, Output output) {
        int height = rgb.length / 3 / width;
        double exposure = Math.pow(2, AutoExposure.stops(environment, rgb, width));
        var image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int code = 0;
                double dither = output == Output.PLAIN ? 0 : ToneMapping.ditherOffset(x, y);
                for (int channel = 0; channel < 3; channel++) {
                    double radiance = rgb[3 * (y * width + x) + channel];
                    double displayed = output == Output.PLAIN
                            ? radiance
                            : ToneMapping.displayValue(radiance, exposure, environment.toneCurve());
                    code = code << 8 | (int) Math.rint(Math.min(Math.max(255 * displayed + dither, 0), 255));
                }
                image.setRGB(x, height - 1 - y, code);
            }
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
