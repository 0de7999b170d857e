package nephele.engine.model.shape;

import nephele.engine.model.Mesh;

/** A sphere around the origin with its poles on the y axis. The first slice begins at +z and continues towards +x. */
public record SphereShape(double radius, int slices, int stacks) implements Shape {
    public SphereShape {
        ShapeParameter.RADIUS.check(radius);
        ShapeParameter.SLICES.check(slices);
        ShapeParameter.STACKS.check(stacks);
        if (stacks < 2) {
            throw new IllegalArgumentException("STACKS is 1, but a sphere has to have at least 2");
        }
    }

    @Override
    public Mesh mesh() {
        var mesh = new MeshBuilder(2 * slices + (stacks - 1) * (slices + 1), maxTriangles());
        pole(mesh, -1);
        Circle circle = Circle.of(slices);
        int rings = mesh.nextVertex();
        for (int stack = 1; stack < stacks; stack++) {
            ring(mesh, circle, stack);
        }
        int north = mesh.nextVertex();
        pole(mesh, 1);
        caps(mesh, rings, north);
        mesh.grid(rings, slices, stacks - 2);
        return mesh.mesh();
    }

    @Override
    public int maxTriangles() {
        return 2 * slices * (stacks - 1);
    }

    /** Adds one vertex for each slice, with the texture coordinate of the slice's middle. */
    private void pole(MeshBuilder mesh, int sign) {
        for (int i = 0; i < slices; i++) {
            mesh.point(0, sign * radius, 0).normal(0, sign, 0).texture((i + 0.5) / slices, (1 + sign) / 2);
        }
    }

    private void ring(MeshBuilder mesh, Circle circle, int stack) {
        double y = -Circle.cosineOf(stack, 2 * stacks);
        double around = Circle.sineOf(stack, 2 * stacks);
        for (int i = 0; i <= slices; i++) {
            double x = around * circle.sine()[i];
            double z = around * circle.cosine()[i];
            mesh.point(radius * x, radius * y, radius * z)
                    .normal(x, y, z)
                    .texture((double) i / slices, (double) stack / stacks);
        }
    }

    private void caps(MeshBuilder mesh, int rings, int north) {
        int last = rings + (stacks - 2) * (slices + 1);
        for (int i = 0; i < slices; i++) {
            mesh.triangle(i, rings + i + 1, rings + i);
            mesh.triangle(last + i, last + i + 1, north + i);
        }
    }
}
