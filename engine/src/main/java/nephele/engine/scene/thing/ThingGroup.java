package nephele.engine.scene.thing;

import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.thing.ThingMesh.Range;

/**
 * Things of one shape and one kind of material: drawn with one program and, where all are seen, with one call.
 *
 * @param steps index ranges from the finest mesh to the coarsest
 * @param headless the same without the part that may enclose the eye, the last; {@code null} where none does
 * @param flatness for each step how far its flat sides lie within the shape, in radii
 * @param kind of material
 * @param parts of each thing; as many instances follow each other for every copy of it
 */
public record ThingGroup(Range[] steps, Range[] headless, double[] flatness, SolidBatch.Kind kind, int parts) {}
