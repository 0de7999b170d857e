package nephele.engine.model.shape;

import nephele.engine.model.Mesh;

/**
 * A square in the xz plane around the origin.
 *
 * @param length edge length
 * @param divisions divisions of an edge
 * @param sides the faces of the square
 */
public record PlaneShape(double length, int divisions, Sides sides) implements Shape {
    /** The faces of a plane. */
    public enum Sides {
        /** One face towards +y. */
        TOP,
        /** Two coincident faces, because back faces are not drawn. */
        BOTH
    }

    public PlaneShape {
        ShapeParameter.LENGTH.check(length);
        ShapeParameter.DIVISIONS.check(divisions);
    }

    @Override
    public Mesh mesh() {
        int faces = sides == Sides.BOTH ? 2 : 1;
        var mesh = new MeshBuilder(faces * (divisions + 1) * (divisions + 1), maxTriangles());
        SquareFace.TOP.add(mesh, length, divisions, 0);
        if (sides == Sides.BOTH) {
            SquareFace.BOTTOM.add(mesh, length, divisions, 0);
        }
        return mesh.mesh();
    }

    @Override
    public int maxTriangles() {
        return (sides == Sides.BOTH ? 4 : 2) * divisions * divisions;
    }
}
