package nephele.app.play.hud;

import nephele.engine.render.pass.overlay.OverlayColour;

/** The overlay's colours, sRGB. */
public final class HudPalette {
    public static final OverlayColour INK = OverlayColour.opaque(0xf3f6fa);
    static final OverlayColour QUIET_INK = OverlayColour.opaque(0xa9b6c6);
    public static final OverlayColour ACCENT = OverlayColour.opaque(0x86ccff);
    static final OverlayColour PANEL = OverlayColour.opaque(0x0b1119).withAlpha(0.78);
    static final OverlayColour HANDLE = OverlayColour.opaque(0x0b1119).withAlpha(0.9);
    public static final OverlayColour VEIL = OverlayColour.opaque(0x0b1119).withAlpha(0.45);
    static final OverlayColour SELECTED = OverlayColour.opaque(0x86ccff).withAlpha(0.18);
    static final OverlayColour SHADOW = OverlayColour.opaque(0x000000).withAlpha(0.4);

    private HudPalette() {}
}
