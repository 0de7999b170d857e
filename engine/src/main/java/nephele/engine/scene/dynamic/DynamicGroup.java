package nephele.engine.scene.dynamic;

import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.dynamic.DynamicMesh.Range;

/**
 * Dynamic objects of one shape and one kind of material: drawn with one program and, if all are visible, with one call.
 *
 * @param steps index ranges of the levels of detail, from the finest to the coarsest
 * @param headless the same without the last part, which may enclose the eye; {@code null} if there is no such part
 * @param flatness for each level of detail the depth of its flat sides below the exact surface, in radii
 * @param kind kind of material
 * @param parts number of parts of each object; as many contiguous instances belong to each copy
 */
public record DynamicGroup(Range[] steps, Range[] headless, double[] flatness, SolidBatch.Kind kind, int parts) {}
