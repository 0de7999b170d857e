package nephele.engine.level.appearance;

/** The meaning of the 8 bits of a colour picture. */
public enum ColourDecoding {
    /** IEC 61966-2-1 to linear values, for pictures of materials and skies. */
    SRGB,
    /** The stored value divided by 255, for output {@code plain}. */
    AS_STORED;

    /** Returns the linear value of each of the 256 codes. */
    public double[] table() {
        double[] linear = new double[256];
        for (int code = 0; code < linear.length; code++) {
            linear[code] = linear(code / 255.0);
        }
        return linear;
    }

    /** Returns the linear value of a stored one; both are 0 to 1. */
    public double linear(double stored) {
        if (this == AS_STORED) {
            return stored;
        }
        return stored <= 0.04045 ? stored / 12.92 : StrictMath.pow((stored + 0.055) / 1.055, 2.4);
    }
}
