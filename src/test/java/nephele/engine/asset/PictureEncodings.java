package nephele.engine.asset;

import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntUnaryOperator;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;

/**
 * One picture of four coloured quarters, in many encodings made by code.
 *
 * @param name ends in the file's extension
 */
record PictureEncodings(String name, byte[] bytes) {
    static final int SIDE = 32;

    /** Upper left and right, lower left and right; all channels are multiples of 17 and none is dark. */
    static final int[] QUARTERS = {0xcc5566, 0x6677dd, 0x88cc77, 0xeeddbb};

    private static final byte[] LINEAR =
            ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB).getData();
    private static final byte[] SRGB =
            ICC_Profile.getInstance(ColorSpace.CS_sRGB).getData();

    @Override
    public String toString() {
        return name;
    }

    static int rgb(int x, int y) {
        return QUARTERS[(x < SIDE / 2 ? 0 : 1) + (y < SIDE / 2 ? 0 : 2)];
    }

    static List<PictureEncodings> ofColours() {
        List<PictureEncodings> all = new ArrayList<>();
        jpegs(all);
        pngs(all);
        tgas(all);
        bmps(all);
        return all;
    }

    private static void jpegs(List<PictureEncodings> all) {
        add(all, "ycbcr.jpg", jpeg(image(), false));
        add(all, "progressive.jpg", jpeg(image(), true));
        byte[] rgb = jpeg(raster(3, PictureEncodings::rgb), false);
        add(all, "rgb-adobe-0.jpg", withSegment(rgb, adobe(0)));
        byte[] cmyk = jpeg(raster(4, (x, y) -> inks(rgb(x, y))), false);
        add(all, "cmyk-adobe-0.jpg", withSegment(cmyk, adobe(0)));
        byte[] ycck = jpeg(raster(4, (x, y) -> ycck(inks(rgb(x, y)))), false);
        add(all, "ycck-adobe-2.jpg", withSegment(ycck, adobe(2)));
        add(all, "profile-linear.jpg", withSegment(jpeg(linearImage(), false), profile(LINEAR)));
        add(all, "profile-srgb.jpg", withSegment(jpeg(image(), false), profile(SRGB)));
        add(all, "profile-damaged.jpg", withSegment(jpeg(image(), false), profile(new byte[200])));
    }

    private static void pngs(List<PictureEncodings> all) {
        byte[] eight = rows(3, 8, PictureEncodings::rgb);
        byte[] linear = rows(3, 16, (x, y) -> linear(rgb(x, y)));
        add(all, "rgb8.png", png(2, 8, eight));
        add(all, "rgb16.png", png(2, 16, rows(3, 16, PictureEncodings::rgb)));
        add(all, "rgba8.png", png(6, 8, rows(4, 8, (x, y) -> rgb(x, y))));
        add(all, "rgba16.png", png(6, 16, rows(4, 16, (x, y) -> rgb(x, y))));
        add(all, "interlaced.png", interlaced(image()));
        add(all, "interlaced-palette.png", interlaced(paletteImage()));
        add(all, "transparent-colour.png", png(2, 8, eight, chunk("tRNS", new byte[] {0, 1, 0, 2, 0, 3})));
        add(all, "profile-linear.png", png(2, 16, linear, pngProfile(LINEAR)));
        add(all, "profile-linear-alpha.png", png(6, 16, rows(4, 16, (x, y) -> linear(rgb(x, y))), pngProfile(LINEAR)));
        add(all, "profile-srgb.png", png(2, 8, eight, pngProfile(SRGB)));
        add(all, "gamma-1.png", png(2, 16, linear, chunk("gAMA", bigEndian(100_000))));
        byte[] roots = rows(3, 8, (x, y) -> each(rgb(x, y), value -> (int) Math.rint(255 * Math.sqrt(light(value)))));
        add(all, "gamma-half.png", png(2, 8, roots, chunk("gAMA", bigEndian(50_000))));
        add(all, "gamma-srgb.png", png(2, 8, eight, chunk("gAMA", bigEndian(45_455))));
        add(
                all,
                "gamma-1-but-srgb.png",
                png(2, 8, eight, chunk("gAMA", bigEndian(100_000)), chunk("sRGB", new byte[1])));
        add(all, "wide-primaries.png", wide());
        add(all, "cicp-srgb.png", png(2, 8, eight, chunk("cICP", new byte[] {1, 13, 0, 1})));
        for (int bits : new int[] {2, 4, 8}) {
            byte[] palette = new byte[12];
            for (int i = 0; i < 12; i++) {
                palette[i] = (byte) (QUARTERS[i / 3] >> 16 - 8 * (i % 3));
            }
            add(all, "palette" + bits + ".png", png(3, bits, packed(bits), chunk("PLTE", palette)));
            add(
                    all,
                    "palette" + bits + "-transparent.png",
                    png(3, bits, packed(bits), chunk("PLTE", palette), chunk("tRNS", new byte[] {-1, -1, -1, -1})));
        }
    }

    private static void tgas(List<PictureEncodings> all) {
        for (int corner : new int[] {0, 0x10, 0x20, 0x30}) {
            add(all, "corner-" + corner + ".tga", tga(2, 24, corner, new byte[0], 0));
            add(all, "runs-corner-" + corner + ".tga", tga(10, 24, corner, new byte[0], 0));
        }
        byte[] entries = new byte[12];
        for (int i = 0; i < 12; i++) {
            entries[i] = (byte) (QUARTERS[i / 3] >> 8 * (i % 3));
        }
        add(all, "32-alpha.tga", tga(2, 32, 0x28, new byte[0], 0));
        add(all, "32-no-alpha.tga", tga(2, 32, 0x20, new byte[0], 0));
        add(all, "unused-palette.tga", tga(2, 24, 0x20, entries, 0));
        add(all, "unused-palette-runs.tga", tga(10, 24, 0x20, entries, 0));
        for (int first : new int[] {0, 3, 40}) {
            add(all, "palette-from-" + first + ".tga", tga(1, 8, 0x20, entries, first));
            add(all, "palette-runs-from-" + first + ".tga", tga(9, 8, 0, entries, first));
        }
    }

    private static void bmps(List<PictureEncodings> all) {
        add(all, "written.bmp", SamplePictures.written(image(), "bmp"));
        add(all, "32-reserved-0.bmp", bmp(40, 32, 0, true, new byte[0]));
        add(all, "24-from-top.bmp", bmp(40, 24, 0, false, new byte[0]));
        add(all, "v5-profile-srgb.bmp", bmp(124, 24, 0, true, SRGB));
        add(all, "v5-profile-damaged.bmp", bmp(124, 24, 0, true, new byte[64]));
    }

    private static void add(List<PictureEncodings> all, String name, byte[] bytes) {
        all.add(new PictureEncodings(name, bytes));
    }

    /** A colour, or four bands, of each pixel. */
    interface Colours {
        int at(int x, int y);
    }

    static BufferedImage image() {
        BufferedImage image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < SIDE * SIDE; i++) {
            image.setRGB(i % SIDE, i / SIDE, rgb(i % SIDE, i / SIDE));
        }
        return image;
    }

    private static BufferedImage linearImage() {
        BufferedImage image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < SIDE * SIDE; i++) {
            image.setRGB(i % SIDE, i / SIDE, linear(rgb(i % SIDE, i / SIDE)));
        }
        return image;
    }

    private static int linear(int rgb) {
        return each(rgb, value -> (int) Math.rint(255 * light(value)));
    }

    private static double light(int value) {
        double share = value / 255.0;
        return share <= .04045 ? share / 12.92 : Math.pow((share + .055) / 1.055, 2.4);
    }

    private static int each(int rgb, IntUnaryOperator change) {
        return change.applyAsInt(rgb >> 16 & 255) << 16
                | change.applyAsInt(rgb >> 8 & 255) << 8
                | change.applyAsInt(rgb & 255);
    }

    /** Returns 255 − cyan, magenta, yellow and black, with as much black as there can be. */
    private static int inks(int rgb) {
        int light = Math.max(rgb >> 16 & 255, Math.max(rgb >> 8 & 255, rgb & 255));
        return each(rgb, value -> (value * 255 + light / 2) / light) << 8 | light;
    }

    private static int ycck(int inks) {
        int r = 255 - (inks >>> 24);
        int g = 255 - (inks >> 16 & 255);
        int b = 255 - (inks >> 8 & 255);
        int y = (int) Math.rint(.299 * r + .587 * g + .114 * b);
        int blue = (int) Math.rint(128 - .168736 * r - .331264 * g + .5 * b);
        int red = (int) Math.rint(128 + .5 * r - .418688 * g - .081312 * b);
        return y << 24 | Math.min(255, blue) << 16 | Math.min(255, red) << 8 | inks & 255;
    }

    static Raster raster(int bands, Colours colours) {
        WritableRaster raster = Raster.createInterleavedRaster(DataBuffer.TYPE_BYTE, SIDE, SIDE, bands, null);
        for (int i = 0; i < SIDE * SIDE * bands; i++) {
            int pixel = i / bands;
            int band = i % bands;
            int colour = colours.at(pixel % SIDE, pixel / SIDE);
            raster.setSample(pixel % SIDE, pixel / SIDE, band, colour >> 8 * (bands - 1 - band) & 255);
        }
        return raster;
    }

    /** @param picture a {@link BufferedImage}, or a {@link Raster} that is written as it is */
    static byte[] jpeg(Object picture, boolean isProgressive) {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        ImageWriteParam how = writer.getDefaultWriteParam();
        how.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
        how.setCompressionQuality(1);
        how.setProgressiveMode(isProgressive ? ImageWriteParam.MODE_DEFAULT : ImageWriteParam.MODE_DISABLED);
        return written(
                writer,
                picture instanceof Raster raster
                        ? new IIOImage(raster, null, null)
                        : new IIOImage((BufferedImage) picture, null, null),
                how);
    }

    private static BufferedImage paletteImage() {
        byte[][] bands = new byte[3][4];
        for (int i = 0; i < 12; i++) {
            bands[i % 3][i / 3] = (byte) (QUARTERS[i / 3] >> 16 - 8 * (i % 3));
        }
        var colours = new IndexColorModel(2, 4, bands[0], bands[1], bands[2]);
        var image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_BYTE_BINARY, colours);
        image.createGraphics().drawImage(image(), 0, 0, null);
        return image;
    }

    private static byte[] interlaced(BufferedImage image) {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        ImageWriteParam how = writer.getDefaultWriteParam();
        how.setProgressiveMode(ImageWriteParam.MODE_DEFAULT);
        return written(writer, new IIOImage(image, null, null), how);
    }

    private static byte[] written(ImageWriter writer, IIOImage image, ImageWriteParam how) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (var stream = ImageIO.createImageOutputStream(out)) {
            writer.setOutput(stream);
            writer.write(null, image, how);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        } finally {
            writer.dispose();
        }
        return out.toByteArray();
    }

    static byte[] withSegment(byte[] jpeg, byte[] segment) {
        return ByteBuffer.allocate(jpeg.length + segment.length)
                .put(jpeg, 0, 2)
                .put(segment)
                .put(jpeg, 2, jpeg.length - 2)
                .array();
    }

    static byte[] adobe(int transform) {
        return ByteBuffer.allocate(16)
                .putShort((short) 0xffee)
                .putShort((short) 14)
                .put("Adobe".getBytes(StandardCharsets.US_ASCII))
                .putShort((short) 100)
                .put(15, (byte) transform)
                .array();
    }

    private static byte[] profile(byte[] icc) {
        return ByteBuffer.allocate(18 + icc.length)
                .putShort((short) 0xffe2)
                .putShort((short) (16 + icc.length))
                .put("ICC_PROFILE\0\1\1".getBytes(StandardCharsets.US_ASCII))
                .put(icc)
                .array();
    }

    static byte[] pngProfile(byte[] icc) {
        byte[] packed = SamplePictures.deflated(icc);
        return chunk(
                "iCCP",
                ByteBuffer.allocate(3 + packed.length)
                        .put((byte) 'n')
                        .position(3)
                        .put(packed)
                        .array());
    }

    private static byte[] chunk(String type, byte[] content) {
        return SamplePictures.chunk(type, content);
    }

    private static byte[] bigEndian(int... values) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * values.length);
        for (int value : values) {
            bytes.putInt(value);
        }
        return bytes.array();
    }

    static byte[] png(int colour, int bits, byte[] rows, byte[]... before) {
        byte[][] chunks = java.util.Arrays.copyOf(before, before.length + 1);
        chunks[before.length] = chunk("IDAT", SamplePictures.deflated(rows));
        return SamplePictures.png(SamplePictures.header(SIDE, SIDE, bits, colour, 0), chunks);
    }

    /** The colours as amounts of Adobe RGB's primaries, in linear light of 16 bits. */
    private static byte[] wide() {
        ByteArrayOutputStream rows = new ByteArrayOutputStream();
        for (int y = 0; y < SIDE; y++) {
            rows.write(0);
            for (int x = 0; x < SIDE; x++) {
                double red = light(rgb(x, y) >> 16 & 255);
                double green = light(rgb(x, y) >> 8 & 255);
                double blue = light(rgb(x, y) & 255);
                for (double wide : new double[] {.7152 * red + .2848 * green, green, .0412 * green + .9588 * blue}) {
                    int value = (int) Math.rint(65_535 * wide);
                    rows.write(value >> 8);
                    rows.write(value);
                }
            }
        }
        byte[] primaries = bigEndian(31_270, 32_900, 64_000, 33_000, 21_000, 71_000, 15_000, 6_000);
        return png(2, 16, rows.toByteArray(), chunk("gAMA", bigEndian(100_000)), chunk("cHRM", primaries));
    }

    /** Returns rows with filter 0; a fourth channel is opaque. */
    private static byte[] rows(int channels, int bits, Colours colours) {
        ByteArrayOutputStream rows = new ByteArrayOutputStream();
        for (int y = 0; y < SIDE; y++) {
            rows.write(0);
            for (int x = 0; x < SIDE; x++) {
                for (int channel = 0; channel < channels; channel++) {
                    int value = channel == 3 ? 255 : colours.at(x, y) >> 16 - 8 * channel & 255;
                    for (int i = 0; i < bits / 8; i++) {
                        rows.write(value);
                    }
                }
            }
        }
        return rows.toByteArray();
    }

    private static byte[] packed(int bits) {
        ByteArrayOutputStream rows = new ByteArrayOutputStream();
        for (int y = 0; y < SIDE; y++) {
            rows.write(0);
            int byteSoFar = 0;
            for (int x = 0; x < SIDE; x++) {
                byteSoFar = byteSoFar << bits | (x < SIDE / 2 ? 0 : 1) + (y < SIDE / 2 ? 0 : 2);
                if ((x + 1) * bits % 8 == 0) {
                    rows.write(byteSoFar);
                    byteSoFar = 0;
                }
            }
        }
        return rows.toByteArray();
    }

    /** @param entries colours of three bytes; used by types 1 and 9 only */
    private static byte[] tga(int type, int bits, int descriptor, byte[] entries, int first) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(ByteBuffer.allocate(18)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put(1, (byte) (entries.length > 0 ? 1 : 0))
                .put(2, (byte) type)
                .putShort(3, (short) first)
                .putShort(5, (short) (entries.length / 3))
                .put(7, (byte) (entries.length > 0 ? 24 : 0))
                .putShort(12, (short) SIDE)
                .putShort(14, (short) SIDE)
                .put(16, (byte) bits)
                .put(17, (byte) descriptor)
                .array());
        out.writeBytes(entries);
        for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
            if (type > 8 && pixel % 16 == 0) {
                out.write(0x80 | 15);
            } else if (type > 8) {
                continue;
            }
            int x = (descriptor & 0x10) == 0 ? pixel % SIDE : SIDE - 1 - pixel % SIDE;
            int y = (descriptor & 0x20) == 0 ? SIDE - 1 - pixel / SIDE : pixel / SIDE;
            int quarter = (x < SIDE / 2 ? 0 : 1) + (y < SIDE / 2 ? 0 : 2);
            if (bits == 8) {
                out.write(first + quarter);
                continue;
            }
            for (int channel = 0; channel < 3; channel++) {
                out.write(QUARTERS[quarter] >> 8 * channel);
            }
            for (int i = 24; i < bits; i += 8) {
                out.write((descriptor & 15) == 0 ? 0 : 255);
            }
        }
        return out.toByteArray();
    }

    private static byte[] bmp(int header, int bits, int compression, boolean isFromBottom, byte[] profile) {
        int pixels = SIDE * SIDE * bits / 8;
        ByteBuffer file =
                ByteBuffer.allocate(14 + header + pixels + profile.length).order(ByteOrder.LITTLE_ENDIAN);
        file.putShort((short) 0x4d42).putInt(file.limit()).putInt(0).putInt(14 + header);
        file.putInt(header).putInt(SIDE).putInt(isFromBottom ? SIDE : -SIDE);
        file.putShort((short) 1).putShort((short) bits).putInt(compression).putInt(pixels);
        if (header == 124) {
            file.putInt(14 + 56, 0x4d424544);
            file.putInt(14 + 112, header + pixels);
            file.putInt(14 + 116, profile.length);
        }
        file.position(14 + header);
        for (int row = 0; row < SIDE; row++) {
            for (int x = 0; x < SIDE; x++) {
                int rgb = rgb(x, isFromBottom ? SIDE - 1 - row : row);
                file.put((byte) rgb).put((byte) (rgb >> 8)).put((byte) (rgb >> 16));
                if (bits == 32) {
                    file.put((byte) 0);
                }
            }
        }
        return file.put(profile).array();
    }
}
