package nephele.engine.asset;

import nephele.engine.work.SwingThread;

/**
 * Painted layers of a terrain as a file stores them: each texel names one layer and the weight with which it replaces what
 * would be there. The file is a PNG of 8 bits, grey with alpha: the grey is the layer's index, alpha its weight.
 *
 * @param texels rows from the top, texels from the left; of each the layer's index, then its weight, 0 to 255
 */
public record LayerMap(int columns, int rows, byte[] texels) {
    private static final int GREY_AND_ALPHA = 2;

    /** The colour type of the PNG specification, table 11.1. */
    private static final int PNG_GREY_AND_ALPHA = 4;

    /** The weight that replaces all. */
    public static final int FULL_WEIGHT = 255;

    /** Bytes of a texel. */
    public static final int TEXEL_BYTES = 2;

    public LayerMap {
        if (TEXEL_BYTES * columns * rows != texels.length) {
            throw new IllegalArgumentException("texels do not fit " + columns + "x" + rows);
        }
    }

    /** Returns a map that changes nothing. */
    public static LayerMap blank(int columns, int rows) {
        return new LayerMap(columns, rows, new byte[TEXEL_BYTES * columns * rows]);
    }

    /** Returns the index of a texel's layer; it means nothing where the weight is 0. */
    public int layer(int column, int row) {
        return texels[TEXEL_BYTES * (row * columns + column)] & 0xff;
    }

    /** Returns the weight of a texel's layer, 0 to {@link #FULL_WEIGHT}. */
    public int weight(int column, int row) {
        return texels[TEXEL_BYTES * (row * columns + column) + 1] & 0xff;
    }

    /**
     * Returns the layers of a file.
     *
     * @param assetId names the file in errors
     * @throws AssetException if the file is no such picture, damaged, too small or too large
     */
    public static LayerMap read(String assetId, byte[] bytes) throws AssetException {
        SwingThread.refuse("reading a layer map");
        PictureFormat format = PictureFormat.of(assetId, bytes);
        if (format != PictureFormat.PNG) {
            throw new AssetException(
                    assetId,
                    format == null ? "is no picture" : "is a " + format + " picture",
                    "a layer map is a PNG of 8 bits, grey with alpha");
        }
        Picture picture = PictureDecoder.decode(assetId, bytes, PictureDecoder.Limits.LAYERS);
        if (picture.channels() != GREY_AND_ALPHA || picture.bitsPerChannel() != 8) {
            throw new AssetException(
                    assetId,
                    "has " + picture.channels() + " channels of " + picture.bitsPerChannel() + " bits",
                    "save it as a PNG of 8 bits, grey with alpha");
        }
        if (Math.min(picture.width(), picture.height()) < HeightMap.LEAST_SAMPLES) {
            throw new AssetException(
                    assetId,
                    "has " + picture.width() + " x " + picture.height() + " pixels",
                    "a layer map has at least " + HeightMap.LEAST_SAMPLES + " along each side: scale it");
        }
        return new LayerMap(picture.width(), picture.height(), picture.samples());
    }

    /** Returns a file of the layers, which reads back as the same texels. */
    public byte[] png() {
        return PngEncoder.file(new PngFile.Header(columns, rows, 8, PNG_GREY_AND_ALPHA, 0), texels);
    }
}
