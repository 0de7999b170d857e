package nephele.engine.render.frame;

/** In which form surfaces leave their shaders. */
public enum Output {
    /** Tone-mapped, sRGB, dithered, straight into the 8-bit picture. */
    DIRECT,
    /** Linear radiance into a half-float picture that the tone-mapping pass develops. */
    HDR,
    /** Values as stored: no sRGB decoding or encoding, no exposure, tone curve or dither. */
    PLAIN;

    /** The define that shaders test. */
    public String define() {
        return "OUTPUT_" + name();
    }
}
