package nephele.engine.model.shape;

import nephele.engine.model.Mesh;

/**
 * A torus around the y axis. Slices begin at +z and continue towards +x; stacks begin inside and continue below,
 * outside and above.
 *
 * @param radius of the centre line of the tube
 * @param tube radius of the tube, less than {@code radius}
 */
public record TorusShape(double radius, double tube, int slices, int stacks) implements Shape {
    private static final int LEAST_STACKS = 3;

    public TorusShape {
        ShapeParameter.RADIUS.check(radius);
        ShapeParameter.TUBE.check(tube);
        ShapeParameter.SLICES.check(slices);
        ShapeParameter.STACKS.check(stacks);
        if (tube >= radius) {
            throw new IllegalArgumentException("TUBE has to be less than RADIUS, or the ring goes through itself");
        }
        if (stacks < LEAST_STACKS) {
            throw new IllegalArgumentException("STACKS is " + stacks + ", but a tube has to have at least 3");
        }
    }

    @Override
    public Mesh mesh() {
        var mesh = new MeshBuilder((slices + 1) * (stacks + 1), maxTriangles());
        Circle around = Circle.of(slices);
        Circle section = Circle.of(stacks);
        for (int stack = 0; stack <= stacks; stack++) {
            double out = -section.cosine()[stack];
            double up = -section.sine()[stack];
            for (int i = 0; i <= slices; i++) {
                double x = around.sine()[i];
                double z = around.cosine()[i];
                mesh.point((radius + tube * out) * x, tube * up, (radius + tube * out) * z)
                        .normal(out * x, up, out * z)
                        .texture((double) i / slices, (double) stack / stacks);
            }
        }
        mesh.grid(0, slices, stacks);
        return mesh.mesh();
    }

    @Override
    public int maxTriangles() {
        return 2 * slices * stacks;
    }
}
