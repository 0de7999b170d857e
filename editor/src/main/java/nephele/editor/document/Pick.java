package nephele.editor.document;

import nephele.editor.record.EntityRef;
import nephele.engine.math.Vec3;

/**
 * Something that a ray meets.
 *
 * @param face name of the face of a solid; empty for other entities
 * @param distanceMetres along the ray
 * @param normal outward, unit length
 */
public record Pick(EntityRef entity, String face, double distanceMetres, Vec3 point, Vec3 normal) {}
