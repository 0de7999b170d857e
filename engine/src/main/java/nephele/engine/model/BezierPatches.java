package nephele.engine.model;

import java.util.List;

/**
 * A surface of bicubic patches, as a {@code .patch} file holds it.
 *
 * @param file it came from
 */
public record BezierPatches(String file, List<BezierPatch> patches) {
    static final String SHIPPED = "models/teapot.patch";

    public static BezierPatches read(String file, byte[] bytes) {
        return new PatchFile(file, bytes).read();
    }
}
