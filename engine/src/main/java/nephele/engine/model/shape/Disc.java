package nephele.engine.model.shape;

/** The flat end of a cone or a cylinder: a fan around its centre, with the image orientation of a box's face. */
enum Disc {
    UP(1),
    DOWN(-1);

    private final int sign;

    Disc(int sign) {
        this.sign = sign;
    }

    static int vertices(int slices) {
        return slices + 1;
    }

    void add(MeshBuilder mesh, Circle circle, double radius, double y) {
        int centre = mesh.point(0, y, 0).normal(0, sign, 0).texture(0.5, 0.5);
        int slices = circle.parts();
        for (int i = 0; i < slices; i++) {
            double x = circle.sine()[i];
            double z = circle.cosine()[i];
            mesh.point(radius * x, y, radius * z).normal(0, sign, 0).texture(0.5 + 0.5 * x, 0.5 - sign * 0.5 * z);
        }
        for (int i = 0; i < slices; i++) {
            int here = centre + 1 + i;
            int next = centre + 1 + (i + 1) % slices;
            mesh.triangle(centre, sign > 0 ? here : next, sign > 0 ? next : here);
        }
    }
}
