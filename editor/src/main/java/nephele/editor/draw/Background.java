package nephele.editor.draw;

import nephele.engine.math.Vec3;
import nephele.engine.render.frame.ToneMapping;

/** The brightness behind plans and behind levels without their own sky. */
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
}
