package nephele.workshop.art.paint;

/** A display colour, sRGB components 0–1. */
public record PaintColour(double red, double green, double blue) {
    /** Returns the colour {@code 0xRRGGBB}. */
    public static PaintColour of(int hex) {
        return new PaintColour((hex >> 16 & 255) / 255.0, (hex >> 8 & 255) / 255.0, (hex & 255) / 255.0);
    }

    public PaintColour mix(PaintColour other, double share) {
        return new PaintColour(
                red + (other.red - red) * share,
                green + (other.green - green) * share,
                blue + (other.blue - blue) * share);
    }

    public PaintColour times(double factor) {
        return new PaintColour(red * factor, green * factor, blue * factor);
    }

    public int rgb() {
        return code(red) << 16 | code(green) << 8 | code(blue);
    }

    static int code(double component) {
        return (int) Math.max(0, Math.min(255, Math.floor(component * 255 + 0.5)));
    }
}
