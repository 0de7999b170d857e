package nephele.engine.render.line;

/** A display colour, sRGB values from 0 to 1, alpha not premultiplied. */
public record LineColour(float red, float green, float blue, float alpha) {
    /**
     * Returns a colour.
     *
     * @param rgb 0xRRGGBB as stored in a display
     * @param alpha 0 to 1
     */
    public static LineColour of(int rgb, double alpha) {
        return new LineColour((rgb >> 16 & 255) / 255f, (rgb >> 8 & 255) / 255f, (rgb & 255) / 255f, (float) alpha);
    }

    /** Returns this colour with another alpha, 0 to 1. */
    public LineColour withAlpha(double newAlpha) {
        return new LineColour(red, green, blue, (float) newAlpha);
    }
}
