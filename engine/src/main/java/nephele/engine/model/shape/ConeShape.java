package nephele.engine.model.shape;

import nephele.engine.model.Mesh;

/** A closed cone on the xz plane around the y axis. The first slice begins at +z and continues towards +x. */
public record ConeShape(double radius, double height, int slices, int stacks) implements Shape {
    public ConeShape {
        ShapeParameter.RADIUS.check(radius);
        ShapeParameter.HEIGHT.check(height);
        ShapeParameter.SLICES.check(slices);
        ShapeParameter.STACKS.check(stacks);
    }

    @Override
    public Mesh mesh() {
        int sideVertices = stacks * (slices + 1) + slices;
        var mesh = new MeshBuilder(sideVertices + (slices + 1), maxTriangles());
        Circle circle = Circle.of(slices);
        for (int stack = 0; stack < stacks; stack++) {
            ring(mesh, circle, stack);
        }
        mesh.grid(0, slices, stacks - 1);
        tip(mesh, (stacks - 1) * (slices + 1));
        circle.addDisc(mesh, radius, 0, -1);
        return mesh.mesh();
    }

    @Override
    public int maxTriangles() {
        return 2 * slices * stacks;
    }

    private void ring(MeshBuilder mesh, Circle circle, int stack) {
        double fraction = (double) (stacks - stack) / stacks;
        for (int i = 0; i <= slices; i++) {
            double sine = circle.sine()[i];
            double cosine = circle.cosine()[i];
            mesh.point(radius * fraction * sine, height * stack / stacks, radius * fraction * cosine);
            sideNormal(mesh, sine, cosine).texture((double) i / slices, (double) stack / stacks);
        }
    }

    /** Adds the tip, which has no unique normal: each slice gets a vertex with the normal of its middle. */
    private void tip(MeshBuilder mesh, int ring) {
        for (int i = 0; i < slices; i++) {
            sideNormal(
                    mesh.point(0, height, 0),
                    Circle.sineOf(2 * i + 1, 2 * slices),
                    Circle.cosineOf(2 * i + 1, 2 * slices));
            int tip = mesh.texture((i + 0.5) / slices, 1);
            mesh.triangle(ring + i, ring + i + 1, tip);
        }
    }

    /** Sets the normal (h sin t, r, h cos t) / √(r² + h²). */
    private MeshBuilder sideNormal(MeshBuilder mesh, double sine, double cosine) {
        double length = StrictMath.hypot(radius, height);
        return mesh.normal(height / length * sine, radius / length, height / length * cosine);
    }
}
