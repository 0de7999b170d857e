package nephele.engine.asset;

/**
 * A decoded picture with its values as stored, without colour conversion.
 *
 * @param channels 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA; alpha is not premultiplied
 * @param bitsPerChannel 8 or 16
 * @param samples rows from the top, pixels from the left, channels interleaved; 16-bit values low byte first
 */
public record Picture(int width, int height, int channels, int bitsPerChannel, byte[] samples) {
    public Picture {
        if ((long) width * height * channels * (bitsPerChannel / 8) != samples.length) {
            throw new IllegalArgumentException("samples do not fit " + width + "x" + height + "x" + channels);
        }
    }

    /** Returns the stored value, 0 to 255 or 65535. */
    public int sample(int x, int y, int channel) {
        int index = (y * width + x) * channels + channel;
        return bitsPerChannel == 8
                ? samples[index] & 0xff
                : samples[2 * index] & 0xff | (samples[2 * index + 1] & 0xff) << 8;
    }

    /**
     * Returns the picture as 8-bit RGBA: grey in all of RGB, missing alpha opaque, 16 bits truncated to the upper 8.
     */
    public Picture toRgba8() {
        if (channels == 4 && bitsPerChannel == 8) {
            return this;
        }
        byte[] rgba = new byte[width * height * 4];
        int bytesPerSample = bitsPerChannel / 8;
        int bytesPerPixel = channels * bytesPerSample;
        int green = channels < 3 ? 0 : bytesPerSample;
        int upper = bytesPerSample - 1;
        boolean hasAlpha = channels == 2 || channels == 4;
        int alpha = (channels - 1) * bytesPerSample + upper;
        for (int pixel = 0, in = 0; pixel < width * height; pixel++, in += bytesPerPixel) {
            rgba[4 * pixel] = samples[in + upper];
            rgba[4 * pixel + 1] = samples[in + green + upper];
            rgba[4 * pixel + 2] = samples[in + 2 * green + upper];
            rgba[4 * pixel + 3] = hasAlpha ? samples[in + alpha] : (byte) 0xff;
        }
        return new Picture(width, height, 4, 8, rgba);
    }
}
