package nephele.engine.reference.sky;

import java.util.stream.IntStream;
import nephele.engine.level.appearance.SkyRadiance;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The sky's irradiance by normal, divided by π, integrated over the whole sky with Lambert's cosine: a cube map of
 * {@value #SKY_CELLS}² cells a face, tabulated for a cube of normals and interpolated. The engine uses nine
 * coefficients instead.
 */
public final class SkyLight {
    private static final int SKY_CELLS = 48;
    private static final int NORMAL_STEPS = 32;
    private static final int NODES = NORMAL_STEPS + 1;

    private final double[] table = new double[6 * NODES * NODES * 3];

    public SkyLight(SkyRadiance sky) {
        double[] cells = cells(sky);
        IntStream.range(0, 6 * NODES * NODES).parallel().forEach(node -> {
            double s = 2.0 * (node % NODES) / NORMAL_STEPS - 1;
            double t = 2.0 * (node / NODES % NODES) / NORMAL_STEPS - 1;
            integrate(cells, onCube(node / (NODES * NODES), s, t).normalize(), 3 * node);
        });
    }

    /** Returns direction x, y, z and radiance × solid angle / π for every cell of the sky. */
    private static double[] cells(SkyRadiance sky) {
        double[] cells = new double[6 * SKY_CELLS * SKY_CELLS * 6];
        double total = 0;
        for (int cell = 0; cell < 6 * SKY_CELLS * SKY_CELLS; cell++) {
            double s = 2 * (cell % SKY_CELLS + 0.5) / SKY_CELLS - 1;
            double t = 2 * (cell / SKY_CELLS % SKY_CELLS + 0.5) / SKY_CELLS - 1;
            Vector3d d = onCube(cell / (SKY_CELLS * SKY_CELLS), s, t);
            double solidAngle = StrictMath.pow(d.lengthSquared(), -1.5);
            total += solidAngle;
            d.normalize();
            Vector3d radiance = sky.from(d.x, d.y, d.z).mul(solidAngle);
            d.get(cells, 6 * cell);
            radiance.get(cells, 6 * cell + 3);
        }
        for (int cell = 0; cell < cells.length; cell += 6) {
            for (int channel = 3; channel < 6; channel++) {
                cells[cell + channel] *= 4 / total;
            }
        }
        return cells;
    }

    private static Vector3d onCube(int face, double s, double t) {
        double side = (face & 1) == 0 ? 1 : -1;
        return switch (face / 2) {
            case 0 -> new Vector3d(side, s, t);
            case 1 -> new Vector3d(s, side, t);
            default -> new Vector3d(s, t, side);
        };
    }

    private void integrate(double[] cells, Vector3d normal, int at) {
        for (int i = 0; i < cells.length; i += 6) {
            double cosine = normal.x * cells[i] + normal.y * cells[i + 1] + normal.z * cells[i + 2];
            if (cosine > 0) {
                table[at] += cosine * cells[i + 3];
                table[at + 1] += cosine * cells[i + 4];
                table[at + 2] += cosine * cells[i + 5];
            }
        }
    }

    /** Returns irradiance / π on a surface with the given normal; a constant sky results in its own radiance. */
    public Vector3d ambient(Vector3dc normal) {
        int axis = normal.maxComponent();
        double along = normal.get(axis);
        double s = normal.get(axis == 0 ? 1 : 0) / Math.abs(along);
        double t = normal.get(axis == 2 ? 1 : 2) / Math.abs(along);
        double x = (s + 1) / 2 * NORMAL_STEPS;
        double y = (t + 1) / 2 * NORMAL_STEPS;
        int column = Math.min((int) x, NORMAL_STEPS - 1);
        int row = Math.min((int) y, NORMAL_STEPS - 1);
        int corner = ((2 * axis + (along < 0 ? 1 : 0)) * NODES + row) * NODES + column;
        double fx = x - column;
        double fy = y - row;
        Vector3d sum = new Vector3d();
        add(sum, corner, (1 - fx) * (1 - fy));
        add(sum, corner + 1, fx * (1 - fy));
        add(sum, corner + NODES, (1 - fx) * fy);
        add(sum, corner + NODES + 1, fx * fy);
        return sum;
    }

    private void add(Vector3d sum, int node, double weight) {
        sum.add(weight * table[3 * node], weight * table[3 * node + 1], weight * table[3 * node + 2]);
    }
}
