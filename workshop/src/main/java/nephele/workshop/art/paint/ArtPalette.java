package nephele.workshop.art.paint;

/** The game's colours: pale stone, warm wood, dark metal and one signal colour. */
public final class ArtPalette {
    public static final PaintColour CONCRETE = PaintColour.of(0xBFBBB2);
    public static final PaintColour PLASTER = PaintColour.of(0xE6DFD2);
    public static final PaintColour PANEL = PaintColour.of(0xEDEDE9);
    public static final PaintColour LIMESTONE = PaintColour.of(0xCDC1AA);
    public static final PaintColour TERRAZZO = PaintColour.of(0xD3CABB);
    public static final PaintColour TERRACOTTA = PaintColour.of(0xB8734F);
    public static final PaintColour BRICK = PaintColour.of(0xC79F7C);
    public static final PaintColour MORTAR = PaintColour.of(0xCFC5B4);
    public static final PaintColour OAK = PaintColour.of(0xB98A59);
    public static final PaintColour OAK_DARK = PaintColour.of(0x7E5632);
    public static final PaintColour METAL = PaintColour.of(0x4A4E54);
    public static final PaintColour SIGNAL = PaintColour.of(0xF2A322);
    public static final PaintColour CHARCOAL = PaintColour.of(0x2B2D30);
    public static final PaintColour JOINT = PaintColour.of(0x6F6A62);
    public static final PaintColour TEAL = PaintColour.of(0x2F8C8F);
    public static final PaintColour TEAL_PALE = PaintColour.of(0x8FC9C2);
    public static final PaintColour GLASS = PaintColour.of(0x24363A);
    public static final PaintColour LEAF = PaintColour.of(0x6E8A45);

    private ArtPalette() {}
}
