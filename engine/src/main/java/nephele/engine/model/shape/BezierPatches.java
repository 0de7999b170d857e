package nephele.engine.model.shape;

import java.util.List;

/**
 * A surface of bicubic patches, as stored in a {@code .patch} file.
 *
 * @param file name of the file, for errors
 */
public record BezierPatches(String file, List<BezierPatch> patches) {
    public static final String SHIPPED = "models/teapot.patch";

    /**
     * Reads a {@code .patch} file.
     *
     * @param file its name, for errors
     * @throws nephele.engine.model.ModelFileException if the file is malformed
     */
    public static BezierPatches read(String file, byte[] bytes) {
        return new PatchFile(file, bytes).read();
    }
}
