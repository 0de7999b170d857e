package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/**
 * A mesh file placed by ordered steps, relative to {@code parent}'s frame if there is one.
 *
 * @param material mapped by the mesh's texture coordinates; {@code null} for grey
 * @param portalable true if shots open portals on its flat parts
 * @param impostor true if pictures of it are drawn instead where it is small
 * @param field plants it at many places, each with a random turn about the vertical; {@code transform} is then relative
 *     to a place. Nothing that is simulated depends on those. {@code null} for the one place of {@code transform}
 * @param heightVariation share of the size by which the smallest of a field is smaller: sizes are random from 1 − this
 *     to 1
 */
public record ModelPlacement(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(required = true, text = TextKind.ASSET, prototype = "\"models/vase.obj\"") String file,
        @Written(text = TextKind.ID, refersTo = "models") String parent,
        @Written(most = 1000) List<TransformStep> transform,
        @Written(text = TextKind.ID, refersTo = "materials") String material,
        @Written boolean portalable,
        @Written boolean impostor,
        @Written Billboards.Field field,
        @Written @Range(min = 0, max = 0.9) double heightVariation) {
    /** Creates a model at one place, always drawn as its mesh. */
    public ModelPlacement(
            String id, String file, String parent, List<TransformStep> transform, String material, boolean portalable) {
        this(id, file, parent, transform, material, portalable, false, null, 0);
    }

    /** Returns true if it is planted over a field. */
    public boolean isPlanted() {
        return field != null;
    }

    /** Returns this model with another material. */
    public ModelPlacement withMaterial(String other) {
        return RecordCopy.with(this, "material", other);
    }

    /** Returns this model with other steps. */
    public ModelPlacement withTransform(List<TransformStep> others) {
        return RecordCopy.with(this, "transform", others);
    }

    /** Returns this model drawn as impostors. */
    public ModelPlacement asImpostor() {
        return RecordCopy.with(this, "impostor", true);
    }

    /** Returns this model as impostors over a field. */
    public ModelPlacement over(Billboards.Field otherField, double variation) {
        return RecordCopy.with(this, "impostor", true, "field", otherField, "heightVariation", variation);
    }

    /** One transform step; steps apply in file order, the first one outermost. */
    public sealed interface TransformStep {
        /** {@code "kind": "translate"}. */
        record Translate(@Written(required = true) @Range Vec3 by) implements TransformStep {}

        /** {@code "kind": "rotate"}. */
        record Rotate(
                @Written(required = true, prototype = "[0, 1, 0]") @Range(min = 1e-9, shape = Range.Shape.DIRECTION)
                        Vec3 axis,
                @Written(required = true, prototype = "90") @Range double angleDegrees)
                implements TransformStep {}

        /** {@code "kind": "scale"}. */
        record Scale(
                @Written(required = true, prototype = "[1, 1, 1]")
                        @Range(min = 1e-9, max = 1e7, shape = Range.Shape.EITHER_SIGN)
                        Vec3 by)
                implements TransformStep {}
    }
}
