package nephele.editor.draw;

import nephele.editor.pane.MarkColour;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.render.gl.DisplayColour;

/** The brightness behind plans and behind levels without their own sky, with the shades of marks on it. */
public enum Background {
    DARK(0x1e2227, 0x0b0d0f),
    LIGHT(0xf4f5f7, 0xb4b9c0);

    private final int rgb;
    private final int gapRgb;

    Background(int rgb, int gapRgb) {
        this.rgb = rgb;
        this.gapRgb = gapRgb;
    }

    /** Returns 0xRRGGBB as stored in a display. */
    int rgb() {
        return rgb;
    }

    /** Returns the colour between panes. */
    int gapRgb() {
        return gapRgb;
    }

    /** Returns the linear radiance that is displayed in this colour. */
    Vec3 radiance() {
        return new Vec3(linear(16), linear(8), linear(0));
    }

    private double linear(int shift) {
        return ToneMapping.decodeSrgb((rgb >> shift & 255) / 255.0);
    }

    /** Returns the opaque shade of a mark: a bright one on the dark, to which drawing adds outlines over surfaces. */
    DisplayColour shade(MarkColour colour) {
        return DisplayColour.of(this == DARK ? onDark(colour) : onLight(colour), 1);
    }

    /** Returns the shade of the plate behind letters that stand on a plan's lines. */
    DisplayColour plate() {
        return this == DARK
                ? new DisplayColour(0.09f, 0.1f, 0.115f, 0.85f)
                : new DisplayColour(0.98f, 0.98f, 0.985f, 0.85f);
    }

    private static int onDark(MarkColour colour) {
        return switch (colour) {
            case GRID -> 0x2a2f35;
            case GRID_MAJOR -> 0x3d454e;
            case GROUND -> 0x5d5440;
            case GROUND_MAJOR -> 0x9a8456;
            case AXIS_X -> 0xe8605a;
            case AXIS_Y -> 0x62c466;
            case AXIS_Z -> 0x5c93f2;
            case EDGE -> 0x98a3ae;
            case SELECTED -> 0xffb000;
            case HOVERED -> 0xfff1bd;
            case PREVIEW -> 0x5ad1ff;
            case GUIDE -> 0xcdaaff;
            case ENTITY -> 0x7fe0c3;
            case ALLOWED -> 0x5fe36a;
            case SLIDES -> 0xffd84a;
            case REFUSED -> 0xff5a4f;
            case PROBLEM -> 0xff4fae;
        };
    }

    private static int onLight(MarkColour colour) {
        return switch (colour) {
            case GRID -> 0xe3e6ea;
            case GRID_MAJOR -> 0xc2c8cf;
            case GROUND -> 0xcdb994;
            case GROUND_MAJOR -> 0x93742f;
            case AXIS_X -> 0xc62828;
            case AXIS_Y -> 0x23762a;
            case AXIS_Z -> 0x1d4fbf;
            case EDGE -> 0x4c555f;
            case SELECTED -> 0xc25500;
            case HOVERED -> 0x7a4b00;
            case PREVIEW -> 0x0070ad;
            case GUIDE -> 0x6a3fb5;
            case ENTITY -> 0x00766a;
            case ALLOWED -> 0x1b7f2a;
            case SLIDES -> 0x8f6b00;
            case REFUSED -> 0xc4001a;
            case PROBLEM -> 0xb0006e;
        };
    }
}
