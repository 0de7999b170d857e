package nephele.engine.level.appearance;

/** What the 8 bits of a colour picture stand for. */
public enum ColourDecoding {
    /** IEC 61966-2-1 to linear values: what pictures of materials and skies hold. */
    SRGB,
    /** The stored value over 255, as in output {@code plain}. */
    AS_STORED;

    /** The linear value of each of the 256 codes. */
    public double[] table() {
        double[] linear = new double[256];
        for (int code = 0; code < linear.length; code++) {
            linear[code] = linear(code / 255.0);
        }
        return linear;
    }

    /** The linear value of a stored one; both run from 0 to 1. */
    public double linear(double stored) {
        if (this == AS_STORED) {
            return stored;
        }
        return stored <= 0.04045 ? stored / 12.92 : StrictMath.pow((stored + 0.055) / 1.055, 2.4);
    }
}
