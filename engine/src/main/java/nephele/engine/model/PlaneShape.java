package nephele.engine.model;

/**
 * A square in the xz plane around the origin.
 *
 * @param length of a side
 */
public record PlaneShape(double length, int divisions, Sides sides) implements Shape {
    /** Which faces it has. */
    public enum Sides {
        /** It faces +y. */
        TOP,
        /** Two faces at one place, as back faces are not drawn. */
        BOTH
    }

    public PlaneShape {
        ShapeParameter.LENGTH.check(length);
        ShapeParameter.DIVISIONS.check(divisions);
    }

    @Override
    public Mesh mesh() {
        int faces = sides == Sides.BOTH ? 2 : 1;
        var mesh = new MeshBuilder(faces * (divisions + 1) * (divisions + 1), mostTriangles());
        SquareFace.TOP.add(mesh, length, divisions, 0);
        if (sides == Sides.BOTH) {
            SquareFace.BOTTOM.add(mesh, length, divisions, 0);
        }
        return mesh.mesh();
    }

    @Override
    public int mostTriangles() {
        return (sides == Sides.BOTH ? 4 : 2) * divisions * divisions;
    }
}
