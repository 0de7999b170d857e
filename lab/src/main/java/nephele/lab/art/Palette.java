package nephele.lab.art;

/** The game's colours: pale stone, warm wood, dark metal and one signal colour. */
final class Palette {
    static final Colour CONCRETE = Colour.of(0xBFBBB2);
    static final Colour PLASTER = Colour.of(0xE6DFD2);
    static final Colour PANEL = Colour.of(0xEDEDE9);
    static final Colour LIMESTONE = Colour.of(0xCDC1AA);
    static final Colour TERRAZZO = Colour.of(0xD3CABB);
    static final Colour TERRACOTTA = Colour.of(0xB8734F);
    static final Colour BRICK = Colour.of(0xC79F7C);
    static final Colour MORTAR = Colour.of(0xCFC5B4);
    static final Colour OAK = Colour.of(0xB98A59);
    static final Colour OAK_DARK = Colour.of(0x7E5632);
    static final Colour METAL = Colour.of(0x4A4E54);
    static final Colour SIGNAL = Colour.of(0xF2A322);
    static final Colour CHARCOAL = Colour.of(0x2B2D30);
    static final Colour JOINT = Colour.of(0x6F6A62);
    static final Colour TEAL = Colour.of(0x2F8C8F);
    static final Colour TEAL_PALE = Colour.of(0x8FC9C2);
    static final Colour GLASS = Colour.of(0x24363A);
    static final Colour LEAF = Colour.of(0x6E8A45);

    private Palette() {}
}
