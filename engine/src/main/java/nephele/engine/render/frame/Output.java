package nephele.engine.render.frame;

import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.render.gl.PixelFormat;

/** The form in which shaders write surfaces. */
public enum Output {
    /** Tone-mapped, sRGB, dithered, directly into the 8-bit picture. */
    DIRECT,
    /** Linear radiance into a half-float picture, which the tone-mapping pass converts. */
    HDR,
    /** Values as stored: no sRGB decoding or encoding, no exposure, tone curve or dither. */
    PLAIN;

    /** The define that shaders test. */
    public String define() {
        return "OUTPUT_" + name();
    }

    /** Returns the format of pictures of colours: decoded from sRGB when sampled, or as stored. */
    public PixelFormat pictures() {
        return this == PLAIN ? PixelFormat.RGBA8 : PixelFormat.SRGB8_ALPHA8;
    }

    /** Returns what the numbers of such pictures mean. */
    public ColourDecoding decoding() {
        return this == PLAIN ? ColourDecoding.AS_STORED : ColourDecoding.SRGB;
    }
}
