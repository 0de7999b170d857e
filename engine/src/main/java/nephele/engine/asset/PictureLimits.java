package nephele.engine.asset;

/**
 * The largest picture that is decoded, and what for.
 *
 * @param isColour true if the numbers are colours, which become sRGB; false if they are kept as stored
 * @param saved the kind of file that messages recommend
 */
record PictureLimits(int sidePixels, long pixels, int fileBytes, boolean isColour, String saved) {
    /** The limits of pictures that are drawn. */
    static final PictureLimits DRAWN =
            new PictureLimits(PictureDecoder.MAX_SIDE_PIXELS, 64L << 20, 64 << 20, true, "8-bit PNG");

    /** The limits of pictures of numbers. */
    static final PictureLimits NUMBERS =
            new PictureLimits(DRAWN.sidePixels(), DRAWN.pixels(), DRAWN.fileBytes(), false, DRAWN.saved());

    /** The limits of height maps. */
    static final PictureLimits HEIGHTS = new PictureLimits(
            HeightMap.MOST_SAMPLES,
            (long) HeightMap.MOST_SAMPLES * HeightMap.MOST_SAMPLES,
            FolderAssets.MAX_FILE_BYTES,
            false,
            "16-bit PNG");

    /** The limits of layer maps. */
    static final PictureLimits LAYERS = new PictureLimits(
            HEIGHTS.sidePixels(), HEIGHTS.pixels(), HEIGHTS.fileBytes(), false, "8-bit grey PNG with alpha");
}
