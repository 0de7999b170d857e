package nephele.engine.render.fixed;

import nephele.engine.model.Mesh;

/** Around the middle of a mesh' box. */
record BoundingSphere(double x, double y, double z, double radius) {
    static BoundingSphere of(Mesh mesh) {
        float[] p = mesh.positions();
        double[] middle = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double least = Double.POSITIVE_INFINITY;
            double greatest = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < p.length; i += 3) {
                least = Math.min(least, p[i]);
                greatest = Math.max(greatest, p[i]);
            }
            middle[axis] = p.length == 0 ? 0 : (least + greatest) / 2;
        }
        double square = 0;
        for (int i = 0; i < p.length; i += 3) {
            double dx = p[i] - middle[0];
            double dy = p[i + 1] - middle[1];
            double dz = p[i + 2] - middle[2];
            square = Math.max(square, dx * dx + dy * dy + dz * dz);
        }
        return new BoundingSphere(middle[0], middle[1], middle[2], Math.sqrt(square));
    }
}
