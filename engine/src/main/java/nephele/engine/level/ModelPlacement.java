package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/** A mesh file placed by ordered steps, relative to {@code parent}'s frame if there is one. */
public record ModelPlacement(String id, String file, String parent, List<TransformStep> transform, String material) {

    /** One step; steps apply in file order, the first one outermost. */
    public sealed interface TransformStep {
        /** {@code "kind": "translate"}. */
        record Translate(Vec3 by) implements TransformStep {}

        /** {@code "kind": "rotate"}. */
        record Rotate(Vec3 axis, double angleDegrees) implements TransformStep {}

        /** {@code "kind": "scale"}. */
        record Scale(Vec3 by) implements TransformStep {}
    }
}
