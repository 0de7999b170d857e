package nephele.engine.model.shape;

import nephele.engine.model.Mesh;

/**
 * A closed cylinder around the y axis, centred at the origin. The first slice begins at +z and continues towards +x.
 */
public record CylinderShape(double radius, double height, int slices) implements Shape {
    public CylinderShape {
        ShapeParameter.RADIUS.check(radius);
        ShapeParameter.HEIGHT.check(height);
        ShapeParameter.SLICES.check(slices);
    }

    @Override
    public Mesh mesh() {
        var mesh = new MeshBuilder(2 * (slices + 1) + 2 * (slices + 1), maxTriangles());
        Circle circle = Circle.of(slices);
        ring(mesh, circle, -height / 2, 0);
        ring(mesh, circle, height / 2, 1);
        mesh.grid(0, slices, 1);
        circle.addDisc(mesh, radius, -height / 2, -1);
        circle.addDisc(mesh, radius, height / 2, 1);
        return mesh.mesh();
    }

    @Override
    public int maxTriangles() {
        return 4 * slices;
    }

    private void ring(MeshBuilder mesh, Circle circle, double y, double t) {
        for (int i = 0; i <= slices; i++) {
            double x = circle.sine()[i];
            double z = circle.cosine()[i];
            mesh.point(radius * x, y, radius * z).normal(x, 0, z).texture((double) i / slices, t);
        }
    }
}
