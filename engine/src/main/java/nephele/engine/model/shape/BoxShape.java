package nephele.engine.model.shape;

import nephele.engine.model.Mesh;

/**
 * A cube around the origin.
 *
 * @param length edge length
 * @param divisions divisions of an edge
 */
public record BoxShape(double length, int divisions) implements Shape {
    public BoxShape {
        ShapeParameter.LENGTH.check(length);
        ShapeParameter.DIVISIONS.check(divisions);
    }

    @Override
    public Mesh mesh() {
        var mesh = new MeshBuilder(6 * (divisions + 1) * (divisions + 1), maxTriangles());
        for (SquareFace face : SquareFace.values()) {
            face.add(mesh, length, divisions, length / 2);
        }
        return mesh.mesh();
    }

    @Override
    public int maxTriangles() {
        return 12 * divisions * divisions;
    }
}
