package nephele.engine.scene.thing;

import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.thing.ThingMesh.Range;

/**
 * Things of one shape and one kind of material: drawn with one program and, where all are seen, with one call.
 *
 * @param steps index ranges from the finest mesh to the coarsest
 * @param kind of material
 * @param parts of each thing; as many instances follow each other for every copy of it
 * @param hiddenFrom {@code steps[0]} less the triangles of the part that may enclose the eye; {@code null} without one
 */
public record ThingGroup(Range[] steps, SolidBatch.Kind kind, int parts, Range hiddenFrom) {}
