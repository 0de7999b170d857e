package nephele.engine.measure;

/**
 * A picture of linear RGB with the primaries of sRGB, in row-major order. Rows may be from the top or from the bottom
 * if all compared pictures agree.
 *
 * @param rgb three finite values a pixel; radiance, or what a display emits from 0 to 1
 */
public record LinearPicture(int width, int height, float[] rgb) {
    /** Rec. 709 luminance weights of linear red, green and blue. */
    private static final double[] LUMINANCE = {0.2126, 0.7152, 0.0722};

    public LinearPicture {
        if (width < 1 || height < 1 || rgb.length != 3 * width * height) {
            throw new IllegalArgumentException("a picture of " + width + "×" + height
                    + " pixels needs three values each, not " + rgb.length + " in all");
        }
        for (int i = 0; i < rgb.length; i++) {
            if (!Float.isFinite(rgb[i])) {
                throw new IllegalArgumentException("pixel " + i / 3 % width + "," + i / 3 / width
                        + " is not finite: its error would pass unnoticed");
            }
        }
    }

    /** Returns the number of pixels. */
    public int pixels() {
        return width * height;
    }

    /** Returns the means of blocks of {@code factor} by {@code factor} pixels; the sides must be multiples of it. */
    public LinearPicture reduced(int factor) {
        if (factor < 1 || width % factor != 0 || height % factor != 0) {
            throw new IllegalArgumentException(width + "×" + height + " pixels make no whole blocks of " + factor);
        }
        int row = width / factor * 3;
        double[] sums = new double[row * (height / factor)];
        for (int i = 0; i < rgb.length; i++) {
            int column = i / 3 % width / factor;
            sums[i / 3 / width / factor * row + 3 * column + i % 3] += rgb[i];
        }
        float[] means = new float[sums.length];
        for (int i = 0; i < means.length; i++) {
            means[i] = (float) (sums[i] / (factor * factor));
        }
        return new LinearPicture(width / factor, height / factor, means);
    }

    double luminance(int pixel) {
        return LUMINANCE[0] * rgb[3 * pixel] + LUMINANCE[1] * rgb[3 * pixel + 1] + LUMINANCE[2] * rgb[3 * pixel + 2];
    }

    void requireSameSize(LinearPicture other) {
        if (width != other.width || height != other.height) {
            throw new IllegalArgumentException("pictures of " + width + "×" + height + " and " + other.width + "×"
                    + other.height + " pixels cannot be compared");
        }
    }
}
