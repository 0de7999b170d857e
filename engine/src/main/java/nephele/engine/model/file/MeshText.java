package nephele.engine.model.file;

import java.io.ByteArrayOutputStream;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshLimits;

/** Writes a mesh as the text of a {@code .3d} file; reading it restores the same numbers to the last bit. */
public final class MeshText {
    private static final double[] TENS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
    private static final int ENOUGH_DIGITS = 9;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream(1 << 16);
    private final StringBuilder row = new StringBuilder();

    private MeshText() {}

    /**
     * Returns the text of a mesh.
     *
     * @throws IllegalArgumentException if the text would exceed the size limit for reading
     */
    public static byte[] of(Mesh mesh) {
        var text = new MeshText();
        text.block("points: x y z", mesh.positions(), 3);
        text.block("normals: x y z", mesh.normals(), 3);
        text.block("texture coordinates: s t, from the picture's bottom-left corner", mesh.textureCoordinates(), 2);
        text.triangles(mesh.indices());
        return text.bytes.toByteArray();
    }

    private void block(String title, float[] numbers, int width) {
        line("# " + title);
        line(Integer.toString(numbers.length / width));
        for (int i = 0; i < numbers.length; i += width) {
            for (int column = 0; column < width; column++) {
                row.append(column == 0 ? "" : " ").append(number(numbers[i + column]));
            }
            line("");
        }
        line("");
    }

    private void triangles(int[] indices) {
        line("# triangles: three points each, from 0, counter-clockwise seen from outside");
        line(Integer.toString(indices.length / 3));
        for (int i = 0; i < indices.length; i += 3) {
            row.append(indices[i])
                    .append(' ')
                    .append(indices[i + 1])
                    .append(' ')
                    .append(indices[i + 2]);
            line("");
        }
    }

    private void line(String words) {
        row.append(words).append('\n');
        bytes.writeBytes(row.toString().getBytes(StandardCharsets.US_ASCII));
        row.setLength(0);
        if (bytes.size() > MeshLimits.MAX_TEXT_BYTES) {
            throw new IllegalArgumentException("the mesh is too large for a .3d file, which has at most "
                    + (MeshLimits.MAX_TEXT_BYTES >> 20) + " MiB; make it coarser");
        }
    }

    /** @throws IllegalArgumentException for NaN and infinities, which no file may contain */
    public static String number(float value) {
        if (!Float.isFinite(value)) {
            throw new IllegalArgumentException(value + " has no place in a file");
        }
        float magnitude = Math.abs(value);
        String sign = value < 0 || 1 / value < 0 ? "-" : "";
        return sign
                + (magnitude == 0 ? "0" : magnitude >= 1e-3f && magnitude < 1e6f ? plain(magnitude) : any(magnitude));
    }

    private static String plain(float magnitude) {
        for (int decimals = 0; decimals < TENS.length; decimals++) {
            long digits = Math.round(magnitude * TENS[decimals]);
            if ((float) (digits / TENS[decimals]) == magnitude) {
                String text = layout(digits, decimals);
                if (Float.parseFloat(text) == magnitude) {
                    return text;
                }
            }
        }
        return any(magnitude);
    }

    private static String layout(long digits, int decimals) {
        if (decimals == 0) {
            return Long.toString(digits);
        }
        long whole = digits / (long) TENS[decimals];
        String rest = Long.toString(digits % (long) TENS[decimals]);
        return whole + "." + "0".repeat(decimals - rest.length()) + rest;
    }

    /**
     * Tries 6 to 9 significant digits, from 1 digit for subnormals. Every decimal number six digits survives a normal float
     * (Matula 1968), so a shorter text is the six-digit one without trailing zeros.
     */
    private static String any(float magnitude) {
        BigDecimal exact = new BigDecimal(magnitude);
        for (int digits = magnitude < Float.MIN_NORMAL ? 1 : 6; digits < ENOUGH_DIGITS; digits++) {
            String text = text(exact, digits);
            if (Float.parseFloat(text) == magnitude) {
                return text;
            }
        }
        return text(exact, ENOUGH_DIGITS);
    }

    private static String text(BigDecimal exact, int digits) {
        return exact.round(new MathContext(digits)).stripTrailingZeros().toString();
    }
}
