package nephele.app.play.hud;

import nephele.engine.render.gl.DisplayColour;

/** The overlay's colours, sRGB. */
public final class HudPalette {
    public static final DisplayColour INK = DisplayColour.opaque(0xf3f6fa);
    static final DisplayColour QUIET_INK = DisplayColour.opaque(0xa9b6c6);
    public static final DisplayColour ACCENT = DisplayColour.opaque(0x86ccff);
    static final DisplayColour PANEL = DisplayColour.opaque(0x0b1119).withAlpha(0.78);
    static final DisplayColour HANDLE = DisplayColour.opaque(0x0b1119).withAlpha(0.9);
    public static final DisplayColour VEIL = DisplayColour.opaque(0x0b1119).withAlpha(0.45);
    static final DisplayColour SELECTED = DisplayColour.opaque(0x86ccff).withAlpha(0.18);
    static final DisplayColour SHADOW = DisplayColour.opaque(0x000000).withAlpha(0.4);

    private HudPalette() {}
}
