package nephele.engine.model.shape;

import nephele.engine.math.Vec3;

/**
 * A face of a box, with the orientation of an image on it: upright on the four sides, with its upper edge at -z on top
 * and at +z below. The diagonals match the pictures of the course from which the scenes come.
 */
enum SquareFace {
    TOP(new Vec3(1, 0, 0), new Vec3(0, 0, -1), false),
    BOTTOM(new Vec3(1, 0, 0), new Vec3(0, 0, 1), true),
    FRONT(new Vec3(1, 0, 0), new Vec3(0, 1, 0), true),
    BACK(new Vec3(-1, 0, 0), new Vec3(0, 1, 0), false),
    RIGHT(new Vec3(0, 0, -1), new Vec3(0, 1, 0), true),
    LEFT(new Vec3(0, 0, 1), new Vec3(0, 1, 0), true);

    private final Vec3 right;
    private final Vec3 up;
    private final Vec3 outward;
    private final boolean isRising;

    /** @param isRising whether the diagonals of the face's cells rise to the right */
    SquareFace(Vec3 right, Vec3 up, boolean isRising) {
        this.right = right;
        this.up = up;
        this.outward = Vec3.of(right.toVector().cross(up.toVector()));
        this.isRising = isRising;
    }

    /** @param distance of the face from the origin */
    void add(MeshBuilder mesh, double length, int divisions, double distance) {
        int first = mesh.nextVertex();
        for (int row = 0; row <= divisions; row++) {
            for (int column = 0; column <= divisions; column++) {
                double a = offset(length, column, divisions);
                double b = offset(length, row, divisions);
                mesh.point(
                                a * right.x() + b * up.x() + distance * outward.x(),
                                a * right.y() + b * up.y() + distance * outward.y(),
                                a * right.z() + b * up.z() + distance * outward.z())
                        .normal(outward.x(), outward.y(), outward.z())
                        .texture((double) column / divisions, (double) row / divisions);
            }
        }
        mesh.grid(first, divisions, divisions, isRising);
    }

    /** Returns the same magnitude from both ends, so that faces join to the last bit. */
    private static double offset(double length, int part, int divisions) {
        return length * (2 * part - divisions) / (2.0 * divisions);
    }
}
