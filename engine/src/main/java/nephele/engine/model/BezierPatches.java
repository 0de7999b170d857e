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

    /** @param tessellation parts of each side of a patch, 1 to 512, within what a mesh may have in all */
    public Mesh mesh(int tessellation) {
        return new BezierShape(this, tessellation).mesh();
    }
}
