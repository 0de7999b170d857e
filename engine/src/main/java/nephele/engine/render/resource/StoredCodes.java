package nephele.engine.render.resource;

import java.util.Arrays;
import nephele.engine.level.appearance.ColourDecoding;

/** The 256 codes of a channel and their linear values. */
public final class StoredCodes {
    private final double[] linear;
    /** The limits between codes, in linear values. */
    private final double[] limits = new double[255];

    public StoredCodes(ColourDecoding decoding) {
        linear = decoding.table();
        for (int code = 0; code < limits.length; code++) {
            limits[code] = decoding.linear((code + 0.5) / 255);
        }
    }

    /** Returns the linear value of a code. */
    public double linear(byte code) {
        return linear[code & 0xff];
    }

    /** Returns the code that is nearest to a linear value. */
    public byte nearest(double value) {
        int place = Arrays.binarySearch(limits, value);
        return (byte) (place < 0 ? -place - 1 : place + 1);
    }
}
