package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/**
 * A mesh file placed by ordered steps, relative to {@code parent}'s frame if there is one.
 *
 * @param material mapped by the mesh's texture coordinates; {@code null} for grey
 * @param portalable true if shots open portals on its flat parts
 */
public record ModelPlacement(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(required = true, text = TextKind.ASSET) String file,
        @Written(text = TextKind.ID, refersTo = "models") String parent,
        @Written(most = 1000) List<TransformStep> transform,
        @Written(text = TextKind.ID, refersTo = "materials") String material,
        @Written boolean portalable) {

    /** One transform step; steps apply in file order, the first one outermost. */
    public sealed interface TransformStep {
        /** {@code "kind": "translate"}. */
        record Translate(@Written(required = true) Vec3 by) implements TransformStep {}

        /** {@code "kind": "rotate"}. */
        record Rotate(@Written(required = true) Vec3 axis, @Written(required = true) double angleDegrees)
                implements TransformStep {}

        /** {@code "kind": "scale"}. */
        record Scale(@Written(required = true) Vec3 by) implements TransformStep {}
    }
}
