package nephele.engine.render.gl;

/** A display colour, sRGB values from 0 to 1, alpha not premultiplied. */
public record DisplayColour(float red, float green, float blue, float alpha) {
    /**
     * Returns a colour.
     *
     * @param rgb 0xRRGGBB as stored in a display
     * @param alpha 0 to 1
     */
    public static DisplayColour of(int rgb, double alpha) {
        return new DisplayColour((rgb >> 16 & 255) / 255f, (rgb >> 8 & 255) / 255f, (rgb & 255) / 255f, (float) alpha);
    }

    /** Returns an opaque colour. @param rgb 0xRRGGBB as stored in a display */
    public static DisplayColour opaque(int rgb) {
        return of(rgb, 1);
    }

    /** Returns this colour with another alpha, 0 to 1. */
    public DisplayColour withAlpha(double newAlpha) {
        return new DisplayColour(red, green, blue, (float) newAlpha);
    }
}
