package nephele.engine.render.frame;

import nephele.engine.level.ToneCurve;

/** The Java twin of {@code tone-mapping.glsl}, in double precision. */
public final class ToneMapping {
    private ToneMapping() {}

    /** Returns the sRGB display value 0–1 of one channel's linear radiance. */
    public static double displayValue(double radiance, double exposure, ToneCurve curve) {
        return encodeSrgb(toneCurve(Math.max(radiance * exposure, 0), curve));
    }

    /** Returns the tone curve. CLIP: min(x, 1). FILMIC: Narkowicz, "ACES Filmic Tone Mapping Curve", 2015. */
    public static double toneCurve(double exposed, ToneCurve curve) {
        return switch (curve) {
            case CLIP -> Math.min(exposed, 1);
            case FILMIC -> {
                double x = Math.min(exposed, 1e4);
                double y = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
                yield Math.min(Math.max(y, 0), 1);
            }
        };
    }

    /** Encodes by IEC 61966-2-1. */
    public static double encodeSrgb(double linear) {
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055;
    }

    /** Decodes by IEC 61966-2-1. */
    public static double decodeSrgb(double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }

    /**
     * Returns a value between −1/2 and 1/2 of an 8-bit code, always the same for a pixel; rows count from the bottom.
     */
    public static double ditherOffset(int column, int row) {
        int fixedPoint = column * 0xC13FA9A9 + row * 0x91E10DA5;
        return ((fixedPoint >>> 24) + 0.5) / 256 - 0.5;
    }

    /** Returns the define that chooses the shader's curve. */
    public static String define(ToneCurve curve) {
        return "TONE_" + curve.name();
    }
}
