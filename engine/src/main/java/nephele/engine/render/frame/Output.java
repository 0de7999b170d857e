package nephele.engine.render.frame;

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
}
