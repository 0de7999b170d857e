package nephele.engine.asset;

import nephele.engine.work.SwingThread;

/** Reads and writes layer maps: PNG pictures of 8 bits, grey with alpha. The grey is the layer's index, alpha its weight. */
public final class LayerMapFile {
    private static final int GREY_AND_ALPHA = 2;

    /** The colour type of the PNG specification, table 11.1. */
    private static final int PNG_GREY_AND_ALPHA = 4;

    private LayerMapFile() {}

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
        Picture picture = PictureDecoder.decode(assetId, bytes, PictureLimits.LAYERS);
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

    /** Returns the file of a map, which reads back as the same texels. */
    public static byte[] png(LayerMap map) {
        return PngEncoder.file(new PngFile.Header(map.columns(), map.rows(), 8, PNG_GREY_AND_ALPHA, 0), map.texels());
    }
}
