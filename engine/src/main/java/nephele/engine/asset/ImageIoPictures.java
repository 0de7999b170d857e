package nephele.engine.asset;

import com.twelvemonkeys.imageio.plugins.bmp.BMPImageReaderSpi;
import com.twelvemonkeys.imageio.plugins.tga.TGAImageReaderSpi;
import com.twelvemonkeys.imageio.stream.ByteArrayImageInputStream;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.DataBufferUShort;
import java.awt.image.IndexColorModel;
import java.awt.image.PixelInterleavedSampleModel;
import java.awt.image.Raster;
import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/** Decodes pictures by {@code javax.imageio}, without a window toolkit. */
final class ImageIoPictures {
    /** Second bytes of markers (ITU-T T.81, table B.1). */
    private static final int JPEG_START_OF_SCAN = 0xda;

    private static final int JPEG_END_OF_IMAGE = 0xd9;

    private ImageIoPictures() {}

    static Picture decode(PictureFormat format, byte[] bytes) throws IOException {
        if (!isWhole(format, bytes)) {
            throw new IOException("its content does not fill its pixels");
        }
        ImageReader reader = reader(format);
        try (ImageInputStream stream = new ByteArrayImageInputStream(padded(format, bytes))) {
            reader.setInput(stream, false, true);
            return picture(reader.read(0));
        } finally {
            reader.dispose();
        }
    }

    /** Returns false for files whose missing pixels the readers would make up. */
    private static boolean isWhole(PictureFormat format, byte[] bytes) {
        return switch (format) {
            case TGA -> TgaRuns.fit(bytes);
            case JPEG -> lastMarker(bytes, JPEG_END_OF_IMAGE) > lastMarker(bytes, JPEG_START_OF_SCAN);
            case PNG, BMP -> true;
        };
    }

    /** Returns the offset of the last marker of a kind, −1 without one; compressed pixels contain none. */
    private static int lastMarker(byte[] bytes, int marker) {
        for (int at = bytes.length - 2; at >= 0; at--) {
            if ((bytes[at] & 0xff) == 0xff && (bytes[at + 1] & 0xff) == marker) {
                return at;
            }
        }
        return -1;
    }

    /** Pads a TGA file, because the reader reads a footer of 26 bytes without a check of the length. */
    private static byte[] padded(PictureFormat format, byte[] bytes) {
        return format == PictureFormat.TGA
                ? Arrays.copyOf(bytes, Math.max(bytes.length, TgaRuns.begin(bytes) + 26))
                : bytes;
    }

    /** Instantiates TwelveMonkeys' readers directly, because the fat jar does not merge provider lists. */
    private static ImageReader reader(PictureFormat format) throws IOException {
        return switch (format) {
            case BMP -> new BMPImageReaderSpi().createReaderInstance(null);
            case TGA -> new TGAImageReaderSpi().createReaderInstance(null);
            case PNG, JPEG -> jdkReader(format.name().toLowerCase(Locale.ROOT));
        };
    }

    private static ImageReader jdkReader(String name) {
        for (var readers = ImageIO.getImageReadersByFormatName(name); readers.hasNext(); ) {
            ImageReader reader = readers.next();
            if (reader.getClass().getName().startsWith("com.sun.")) {
                return reader;
            }
        }
        throw new IllegalStateException("this Java runtime has no " + name + " reader");
    }

    private static boolean namesNoColour(Raster raster, int colours) {
        int[] row = new int[raster.getWidth()];
        for (int y = 0; y < raster.getHeight(); y++) {
            raster.getSamples(0, y, row.length, 1, 0, row);
            if (Arrays.stream(row).anyMatch(index -> index >= colours)) {
                return true;
            }
        }
        return false;
    }

    private static Picture picture(BufferedImage image) throws IOException {
        boolean components = image.getColorModel() instanceof ComponentColorModel;
        if (components && image.getSampleModel() instanceof PixelInterleavedSampleModel) {
            int type = image.getRaster().getDataBuffer().getDataType();
            if (type == DataBuffer.TYPE_BYTE) {
                return bytes(image.getRaster());
            }
            if (type == DataBuffer.TYPE_USHORT) {
                return shorts(image.getRaster());
            }
        }
        return converted(image);
    }

    private static Picture bytes(Raster raster) {
        var model = (PixelInterleavedSampleModel) raster.getSampleModel();
        byte[] data = ((DataBufferByte) raster.getDataBuffer()).getData();
        int[] offsets = model.getBandOffsets();
        int bands = offsets.length;
        int stride = model.getPixelStride();
        byte[] samples = new byte[raster.getWidth() * raster.getHeight() * bands];
        for (int y = 0, out = 0; y < raster.getHeight(); y++) {
            int pixel = y * model.getScanlineStride();
            for (int x = 0; x < raster.getWidth(); x++, pixel += stride) {
                for (int band = 0; band < bands; band++) {
                    samples[out++] = data[pixel + offsets[band]];
                }
            }
        }
        return new Picture(raster.getWidth(), raster.getHeight(), bands, 8, samples);
    }

    private static Picture shorts(Raster raster) {
        var model = (PixelInterleavedSampleModel) raster.getSampleModel();
        short[] data = ((DataBufferUShort) raster.getDataBuffer()).getData();
        int[] offsets = model.getBandOffsets();
        byte[] samples = new byte[raster.getWidth() * raster.getHeight() * offsets.length * 2];
        for (int y = 0, out = 0; y < raster.getHeight(); y++) {
            int pixel = y * model.getScanlineStride();
            for (int x = 0; x < raster.getWidth(); x++, pixel += model.getPixelStride()) {
                for (int offset : offsets) {
                    short value = data[pixel + offset];
                    samples[out++] = (byte) value;
                    samples[out++] = (byte) (value >>> 8);
                }
            }
        }
        return new Picture(raster.getWidth(), raster.getHeight(), offsets.length, 16, samples);
    }

    /** Converts palettes and packed pixels; all are sRGB with at most 8 bits, so the conversion changes no value. */
    private static Picture converted(BufferedImage image) throws IOException {
        ColorModel model = image.getColorModel();
        if (model instanceof IndexColorModel palette && namesNoColour(image.getRaster(), palette.getMapSize())) {
            throw new IOException("a pixel names none of its palette's colours");
        }
        int channels = model.hasAlpha() ? 4 : 3;
        int width = image.getWidth();
        byte[] samples = new byte[width * image.getHeight() * channels];
        int[] row = new int[width];
        for (int y = 0, out = 0; y < image.getHeight(); y++) {
            image.getRGB(0, y, width, 1, row, 0, width);
            for (int argb : row) {
                samples[out++] = (byte) (argb >> 16);
                samples[out++] = (byte) (argb >> 8);
                samples[out++] = (byte) argb;
                if (channels == 4) {
                    samples[out++] = (byte) (argb >>> 24);
                }
            }
        }
        return new Picture(width, image.getHeight(), channels, 8, samples);
    }
}
