package nephele.engine.model.shape;

import nephele.engine.model.Mesh;

/**
 * A square in the xz plane around the origin.
 *
 * @param length edge length
 * @param divisions divisions of an edge
 * @param isTwoSided true for two coincident faces, because back faces are not drawn; false for one towards +y
 */
public record PlaneShape(double length, int divisions, boolean isTwoSided) implements Shape {
    public PlaneShape {
        ShapeParameter.LENGTH.check(length);
        ShapeParameter.DIVISIONS.check(divisions);
    }

    @Override
    public Mesh mesh() {
        int faces = isTwoSided ? 2 : 1;
        var mesh = new MeshBuilder(faces * (divisions + 1) * (divisions + 1), maxTriangles());
        SquareFace.TOP.add(mesh, length, divisions, 0);
        if (isTwoSided) {
            SquareFace.BOTTOM.add(mesh, length, divisions, 0);
        }
        return mesh.mesh();
    }

    @Override
    public int maxTriangles() {
        return (isTwoSided ? 4 : 2) * divisions * divisions;
    }
}
