package nephele.engine.model.file;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshLimits;

/** Writes a mesh as the text of a {@code .3d} file; reading it restores the same numbers to the last bit. */
public final class MeshText {
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
                row.append(column == 0 ? "" : " ").append(FloatText.of(numbers[i + column]));
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
}
