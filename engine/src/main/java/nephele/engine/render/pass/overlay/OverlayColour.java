package nephele.engine.render.pass.overlay;

/** A display colour of the overlay, sRGB values from 0 to 1, alpha not premultiplied. */
public record OverlayColour(float red, float green, float blue, float alpha) {
    /**
     * Returns an opaque colour.
     *
     * @param rgb 0xRRGGBB as stored in a display
     */
    public static OverlayColour opaque(int rgb) {
        return new OverlayColour((rgb >> 16 & 255) / 255f, (rgb >> 8 & 255) / 255f, (rgb & 255) / 255f, 1);
    }

    /** Returns this colour with another alpha, 0 to 1. */
    public OverlayColour withAlpha(double newAlpha) {
        return new OverlayColour(red, green, blue, (float) newAlpha);
    }
}
