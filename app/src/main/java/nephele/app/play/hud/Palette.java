package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.Colour;

/** The overlay's colours, sRGB. */
public final class Palette {
    public static final Colour INK = Colour.opaque(0xf3f6fa);
    static final Colour QUIET_INK = Colour.opaque(0xa9b6c6);
    public static final Colour ACCENT = Colour.opaque(0x86ccff);
    static final Colour PANEL = Colour.opaque(0x0b1119).withAlpha(0.78);
    public static final Colour VEIL = Colour.opaque(0x0b1119).withAlpha(0.45);
    static final Colour SELECTED = Colour.opaque(0x86ccff).withAlpha(0.18);
    static final Colour SHADOW = Colour.opaque(0x000000).withAlpha(0.4);

    /** The colours of the two shots: lighter than those of the portals' rims. */
    static final Colour FIRST = Colour.opaque(0x4db4ff);

    static final Colour SECOND = Colour.opaque(0xffa53d);

    private Palette() {}
}
