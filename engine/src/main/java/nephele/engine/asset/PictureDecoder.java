package nephele.engine.asset;

import java.io.IOException;
import java.util.function.Supplier;
import nephele.engine.work.SwingThread;

/** Decodes picture files in pure Java; size limits are enforced before pixels are allocated. */
public final class PictureDecoder {
    /** Maximum width and height in pixels of pictures that are drawn. */
    public static final int MAX_SIDE_PIXELS = 8192;

    /** Maximum plausible ratio of pixel bytes to file bytes; OpenImageIO's limit (its pull request 5319). */
    private static final int MAX_EXPANSION = 10_000;

    /**
     * The largest picture that is decoded, and what for.
     *
     * @param isColour true if the numbers are colours, which become sRGB; false if they are kept as stored
     * @param saved the kind of file that messages recommend
     */
    record Limits(int sidePixels, long pixels, int fileBytes, boolean isColour, String saved) {
        /** The limits of pictures that are drawn. */
        static final Limits DRAWN = new Limits(MAX_SIDE_PIXELS, 64L << 20, 64 << 20, true, "8-bit PNG");

        /** The limits of pictures of numbers. */
        static final Limits NUMBERS =
                new Limits(DRAWN.sidePixels(), DRAWN.pixels(), DRAWN.fileBytes(), false, DRAWN.saved());

        /** The limits of height maps. */
        static final Limits HEIGHTS = new Limits(
                HeightMap.MOST_SAMPLES,
                (long) HeightMap.MOST_SAMPLES * HeightMap.MOST_SAMPLES,
                FolderAssets.MAX_FILE_BYTES,
                false,
                "16-bit PNG");

        /** The limits of layer maps. */
        static final Limits LAYERS = new Limits(
                HEIGHTS.sidePixels(), HEIGHTS.pixels(), HEIGHTS.fileBytes(), false, "8-bit grey PNG with alpha");
    }

    private PictureDecoder() {}

    /**
     * Decodes PNG, JPEG, BMP or TGA to sRGB.
     *
     * @param assetId names the file in errors; TGA files are recognised by its extension
     * @throws AssetException if the format is unknown, or the picture is damaged or too large
     */
    public static Picture decode(String assetId, byte[] bytes) throws AssetException {
        SwingThread.refuse("reading a picture");
        return decode(assetId, bytes, Limits.DRAWN);
    }

    /**
     * Decodes a picture of numbers, such as normals or densities: whatever colours a PNG file says that its numbers are,
     * they are as stored.
     *
     * @throws AssetException as {@link #decode} does
     */
    public static Picture decodeNumbers(String assetId, byte[] bytes) throws AssetException {
        SwingThread.refuse("reading a picture");
        return decode(assetId, bytes, Limits.NUMBERS);
    }

    static Picture decode(String assetId, byte[] bytes, Limits limits) throws AssetException {
        PictureFormat format = PictureFormat.of(assetId, bytes);
        if (format == null) {
            throw new AssetException(assetId, "is not a picture", "use a PNG, JPEG, BMP or TGA file");
        }
        checkHeader(assetId, format, bytes, limits);
        try {
            return switch (format) {
                case PNG -> png(bytes, limits.isColour());
                case JPEG -> ImageIoPictures.jpeg(bytes);
                case BMP -> bmp(bytes, limits.isColour());
                case TGA -> TgaPixels.decode(bytes);
            };
        } catch (UnreadablePicture kind) {
            throw new AssetException(assetId, kind.getMessage(), kind.remedy(), kind);
        } catch (IOException | RuntimeException problem) {
            throw new AssetException(
                    assetId,
                    "is damaged or of an unknown kind of " + format,
                    "save it again as " + limits.saved(),
                    problem);
        } catch (OutOfMemoryError tooLarge) {
            throw tooLarge(assetId);
        }
    }

    /**
     * Returns what is made of a picture.
     *
     * @throws AssetException that names the picture if memory does not suffice
     */
    public static <T> T inMemory(String assetId, Supplier<T> made) {
        try {
            return made.get();
        } catch (OutOfMemoryError tooLarge) {
            throw tooLarge(assetId);
        }
    }

    private static AssetException tooLarge(String assetId) {
        return new AssetException(
                assetId,
                "does not fit into memory",
                "make the picture smaller, or give Java more, for example `java -Xmx4g -jar …`");
    }

    private static Picture png(byte[] bytes, boolean isColour) throws IOException {
        PngFile file = PngFile.of(bytes);
        PngColours colours = isColour ? file.colours() : PngColours.SRGB;
        return colours.toSrgb(PngPixels.decode(file));
    }

    private static Picture bmp(byte[] bytes, boolean isColour) throws IOException {
        Picture stored = ImageIoPictures.decode(PictureFormat.BMP, bytes);
        byte[] profile = isColour ? PictureFormat.bmpProfile(bytes) : null;
        return profile == null ? stored : ColourProfile.toSrgb(stored, profile);
    }

    private static void checkHeader(String assetId, PictureFormat format, byte[] bytes, Limits limits) {
        if (bytes.length > limits.fileBytes()) {
            throw new AssetException(
                    assetId, "has more than " + (limits.fileBytes() >> 20) + " MiB", "make the picture smaller");
        }
        PictureFormat.Size size = format.size(bytes);
        if (size == null) {
            throw new AssetException(assetId, "is cut off in its header", "copy the file again");
        }
        long pixels = size.width() * size.height();
        if (size.width() < 1 || size.height() < 1) {
            throw new AssetException(assetId, "has no pixels", "save it with a width and height of at least 1");
        }
        if (Math.max(size.width(), size.height()) > limits.sidePixels() || pixels > limits.pixels()) {
            throw new AssetException(
                    assetId,
                    "claims " + size.width() + " x " + size.height() + " pixels",
                    "at most " + limits.sidePixels() + " on a side are read");
        }
        if (4 * pixels > (long) MAX_EXPANSION * bytes.length) {
            throw new AssetException(
                    assetId, "claims " + pixels + " pixels in " + bytes.length + " bytes", "copy the file again");
        }
    }

    /** A picture that is whole, but of a kind that is not read; the message says which. */
    static final class UnreadablePicture extends IOException {
        private static final long serialVersionUID = 1;

        private final String remedy;

        UnreadablePicture(String reason, String remedy) {
            super(reason);
            this.remedy = remedy;
        }

        String remedy() {
            return remedy;
        }
    }
}
