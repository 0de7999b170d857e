package nephele.engine.reference;

import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Vector3dc;

/** A shape that rays intersect. Only its outside is visible: a ray that starts inside does not see it. */
sealed interface TracedShape
        permits TracedSolid, BodyPiece, TriangleMeshShape, TriangleMeshShape.Planted, GroundShape, BillboardShape {
    Aabb bounds();

    /**
     * Returns the parameter at which the ray first enters; infinity if that is before {@code least}, or never. What is
     * beyond {@code most} need not be found.
     */
    double entry(Ray ray, double least, double most);

    /** Returns true if the ray contains any point of it up to the parameter {@code limit}. */
    boolean intersects(Ray ray, double limit);

    /** Returns true if one part of it can shade another, which is impossible for a convex shape. */
    boolean shadesItself();

    /**
     * Returns the surface point at the end of a path on this shape.
     *
     * @param toEye unit
     */
    SurfacePoint at(EyePath path, Vec3 place, Vector3dc toEye, SurfaceAppearance looks);

    /** Returns the light that it emits, as an item of this number; {@code null} if paths alone find it or it is dark. */
    EmissiveSurfaces.Emitter emitter(int item, SurfaceAppearance looks);

    /** The materials of all items. */
    record SurfaceAppearance(FaceMaterials solids, BodySurfaces bodies, MaterialTextures textures) {}
}
