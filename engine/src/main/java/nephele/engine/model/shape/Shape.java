package nephele.engine.model.shape;

import nephele.engine.model.Mesh;

/** A parametric surface that is defined by a few numbers and tessellated into triangles. */
public sealed interface Shape
        permits PlaneShape, BoxShape, ConeShape, SphereShape, CylinderShape, TorusShape, BezierShape {
    /** Returns the tessellated surface. */
    Mesh mesh();

    /** Returns an upper bound of the mesh's number of triangles, reached unless some have no area; needs no mesh. */
    int maxTriangles();
}
