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

    /** Returns the codes and their linear values. */
    public Codes codes() {
        return new Codes(this);
    }

    /** The 256 codes of a channel and their linear values, in both directions. */
    public static final class Codes {
        private static final int GUESSES = 1024;

        private final double[] linear;
        /** The limits between codes, in linear values. */
        private final double[] limits = new double[255];
        /** The code of k / GUESSES, a lower bound for values above it. */
        private final int[] guesses = new int[GUESSES + 1];

        private Codes(ColourDecoding decoding) {
            linear = decoding.table();
            for (int code = 0; code < limits.length; code++) {
                limits[code] = decoding.linear((code + 0.5) / 255);
            }
            int code = 0;
            for (int k = 0; k <= GUESSES; k++) {
                while (code < limits.length && (double) k / GUESSES >= limits[code]) {
                    code++;
                }
                guesses[k] = code;
            }
        }

        /** Returns the linear value of a code. */
        public double linear(byte code) {
            return linear[code & 0xff];
        }

        /** Returns the code that is nearest to a linear value; values beyond 0 and 1 have the code of these. */
        public byte nearest(double value) {
            int code = guesses[(int) (Math.max(0, Math.min(value, 1)) * GUESSES)];
            while (code < limits.length && value >= limits[code]) {
                code++;
            }
            return (byte) code;
        }
    }

    /** Returns the linear value of a stored one; both are 0 to 1. */
    public double linear(double stored) {
        if (this == AS_STORED) {
            return stored;
        }
        return stored <= 0.04045 ? stored / 12.92 : StrictMath.pow((stored + 0.055) / 1.055, 2.4);
    }
}
