package nephele.engine.reference;

import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Vector3dc;

/** Something that rays meet. Only outsides are seen: a ray that begins inside it does not see it. */
sealed interface TracedShape permits TracedSolid, BodyPiece, ModelForm {
    Aabb bounds();

    /** The parameter at which the ray first comes in; infinity where it does so before {@code least}, or never. */
    double entry(Ray ray, double least);

    /** Whether the ray has any point of it up to the parameter {@code limit}. */
    boolean meets(Ray ray, double limit);

    /** Whether one part of it can be in another's shade: never where it is convex. */
    boolean shadesItself();

    /**
     * What is there where a path has ended on it.
     *
     * @param toEye unit
     */
    SurfacePoint at(EyePath path, Vec3 place, Vector3dc toEye, SurfaceLooks looks);
}
