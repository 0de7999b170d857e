package nephele.engine.scene.dynamic;

import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.dynamic.DynamicMesh.Range;

/**
 * Dynamic objects of one shape and one kind of material: drawn with one program and, if all are visible, with one call.
 *
 * @param steps index ranges of the levels of detail, from the finest to the coarsest
 * @param headless the same without the part that may enclose the eye; {@code null} if there is no such part
 * @param gunHolding the same without that part and the right forearm, which the gun in the hand has itself
 * @param flatness for each level of detail the depth of its flat sides below the exact surface, in radii
 * @param kind kind of material
 * @param parts number of parts of each object; as many contiguous instances belong to each copy
 */
public record DynamicGroup(
        Range[] steps, Range[] headless, Range[] gunHolding, double[] flatness, SolidBatch.Kind kind, int parts) {
    /** A group of objects without a head. */
    DynamicGroup(Range[] steps, double[] flatness, SolidBatch.Kind kind) {
        this(steps, null, null, flatness, kind, 1);
    }

    /** Returns true if it has these very index ranges and this kind of material. */
    boolean has(Range[] ranges, SolidBatch.Kind material) {
        return steps == ranges && kind.equals(material);
    }
}
