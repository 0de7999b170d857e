package nephele.engine.model;

/** A surface that is known by a few numbers, and made into triangles by them. */
public sealed interface Shape
        permits PlaneShape, BoxShape, ConeShape, SphereShape, CylinderShape, TorusShape, BezierShape {
    Mesh mesh();

    /** How many triangles the mesh has, or a few more where some have no area; known before it is made. */
    int mostTriangles();
}
