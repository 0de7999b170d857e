package nephele.engine.asset;

import com.twelvemonkeys.imageio.plugins.bmp.BMPImageReaderSpi;
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

/**
 * Decodes pictures by {@code javax.imageio}, without a window toolkit. All rasters of the readers become pictures here, by
 * their colour model: bands that are neither grey nor RGB, with or without alpha, are converted or refused.
 */
final class ImageIoPictures {
    /** Second bytes of markers (ITU-T T.81, table B.1). */
    private static final int JPEG_START_OF_SCAN = 0xda;

    private static final int JPEG_END_OF_IMAGE = 0xd9;
    private static final int ADOBE_YCCK = 2;

    private ImageIoPictures() {}

    /** Decodes a PNG or BMP file; the numbers are as stored. */
    static Picture decode(PictureFormat format, byte[] bytes) throws IOException {
        return read(format, bytes, false);
    }

    /** Decodes a JPEG file to sRGB. */
    static Picture jpeg(byte[] bytes) throws IOException {
        if (lastMarker(bytes, JPEG_END_OF_IMAGE) <= lastMarker(bytes, JPEG_START_OF_SCAN)) {
            // The reader would make the missing pixels up.
            throw new IOException("cut off");
        }
        JpegHeader header = JpegHeader.of(bytes);
        if (header.objection() != null) {
            throw new PictureDecoder.UnreadablePicture(
                    header.objection(), "save it again as a plain JPEG in RGB, or as PNG");
        }
        byte[] profile = header.profile();
        byte[] plain = header.withoutProfile();
        if (header.components() < 4) {
            return ColourProfile.toSrgb(decode(PictureFormat.JPEG, plain), profile);
        }
        byte[] inks = read(PictureFormat.JPEG, plain, true).samples();
        toInks(inks, header.adobeTransform() == ADOBE_YCCK);
        return ColourProfile.ofInks(header.width(), header.height(), inks, profile);
    }

    /** Changes Adobe's four bands, which are stored as 255 − ink, to inks; YCCK is the YCbCr of the first three inks. */
    private static void toInks(byte[] bands, boolean isYcck) {
        for (int i = 0; i < bands.length; i += 4) {
            bands[i + 3] = (byte) ~bands[i + 3];
            if (!isYcck) {
                bands[i] = (byte) ~bands[i];
                bands[i + 1] = (byte) ~bands[i + 1];
                bands[i + 2] = (byte) ~bands[i + 2];
                continue;
            }
            double y = bands[i] & 0xff;
            double blue = (bands[i + 1] & 0xff) - 128;
            double red = (bands[i + 2] & 0xff) - 128;
            // ITU-T T.871, 7; the three results are 255 − the stored band, which is the ink.
            bands[i] = rounded(y + 1.402 * red);
            bands[i + 1] = rounded(y - 0.344136 * blue - 0.714136 * red);
            bands[i + 2] = rounded(y + 1.772 * blue);
        }
    }

    private static byte rounded(double value) {
        return (byte) Math.max(0, Math.min(255, Math.rint(value)));
    }

    /** @param isRaw true for the bands as stored, whatever colours they are */
    private static Picture read(PictureFormat format, byte[] bytes, boolean isRaw) throws IOException {
        ImageReader reader = reader(format);
        try (ImageInputStream stream = new ByteArrayImageInputStream(bytes)) {
            reader.setInput(stream, false, true);
            return isRaw ? bytes(reader.readRaster(0, null)) : picture(reader.read(0));
        } finally {
            reader.dispose();
        }
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

    /** Instantiates TwelveMonkeys' reader directly, because the fat jar does not merge provider lists. */
    private static ImageReader reader(PictureFormat format) throws IOException {
        return switch (format) {
            case BMP -> new BMPImageReaderSpi().createReaderInstance(null);
            case TGA -> throw new IllegalArgumentException("TgaPixels reads it");
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
        ColorModel model = image.getColorModel();
        int colours = ColourProfile.colours(model);
        if (colours == 0 || model.isAlphaPremultiplied()) {
            throw new PictureDecoder.UnreadablePicture(
                    "has colours that are neither grey nor RGB", "save it again as a PNG in RGB");
        }
        boolean hasBands = model.getNumComponents() == colours + (model.hasAlpha() ? 1 : 0);
        boolean components = model instanceof ComponentColorModel && hasBands;
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
