package nephele.workshop.art.paint;

/** A display colour, sRGB components 0–1. */
public record PaintColour(double red, double green, double blue) {
    public static final PaintColour CONCRETE = of(0xBFBBB2);
    public static final PaintColour PLASTER = of(0xE6DFD2);
    public static final PaintColour PANEL = of(0xEDEDE9);
    public static final PaintColour LIMESTONE = of(0xCDC1AA);
    public static final PaintColour TERRAZZO = of(0xD3CABB);
    public static final PaintColour TERRACOTTA = of(0xB8734F);
    public static final PaintColour BRICK = of(0xC79F7C);
    public static final PaintColour MORTAR = of(0xCFC5B4);
    public static final PaintColour OAK = of(0xB98A59);
    public static final PaintColour OAK_DARK = of(0x7E5632);
    public static final PaintColour METAL = of(0x4A4E54);
    public static final PaintColour SIGNAL = of(0xF2A322);
    public static final PaintColour CHARCOAL = of(0x2B2D30);
    public static final PaintColour JOINT = of(0x6F6A62);
    public static final PaintColour TEAL = of(0x2F8C8F);
    public static final PaintColour TEAL_PALE = of(0x8FC9C2);
    public static final PaintColour GLASS = of(0x24363A);
    public static final PaintColour LEAF = of(0x6E8A45);

    /** Returns the colour {@code 0xRRGGBB}. */
    public static PaintColour of(int hex) {
        return new PaintColour((hex >> 16 & 255) / 255.0, (hex >> 8 & 255) / 255.0, (hex & 255) / 255.0);
    }

    public PaintColour mix(PaintColour other, double fraction) {
        return new PaintColour(
                red + (other.red - red) * fraction,
                green + (other.green - green) * fraction,
                blue + (other.blue - blue) * fraction);
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
