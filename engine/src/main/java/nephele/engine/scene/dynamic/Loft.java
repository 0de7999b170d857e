package nephele.engine.scene.dynamic;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.scene.dynamic.DynamicMesh.Builder;
import org.joml.Vector3d;

/**
 * A closed surface through superelliptic sections along a curve, which its first and last section close. The parts of the
 * portal gun and of the arm that holds it consist of these. A section stands at right angles to the curve.
 */
final class Loft {
    private static final double[] FORWARD = {0, 0, -1};

    /** A section with its half sides along the curve's right and up, metres. */
    private record Section(Vector3d centre, double halfWidth, double halfHeight) {}

    private final List<Section> sections = new ArrayList<>();
    /** Whether there is an edge at every section. */
    private final boolean isEdged;

    private final int sides;
    private double roundness = 1;
    private Vector3d up = new Vector3d(0, 1, 0);

    private Loft(boolean isEdged, int sides) {
        this.isEdged = isEdged;
        this.sides = sides;
    }

    /** Returns one smooth surface, still without sections. */
    static Loft smooth(int sides) {
        return new Loft(false, sides);
    }

    /** Returns a surface with an edge at every section: narrow bands between wide ones are bevels. */
    static Loft edged(int sides) {
        return new Loft(true, sides);
    }

    /** Sets the exponent of the sections: 1 an ellipse, near 0 a rectangle. */
    Loft roundness(double exponent) {
        roundness = exponent;
        return this;
    }

    /** Sets the direction that the sections' heights follow. */
    Loft up(double x, double y, double z) {
        up = new Vector3d(x, y, z).normalize();
        return this;
    }

    /** Adds a section. */
    Loft at(double x, double y, double z, double halfWidth, double halfHeight) {
        sections.add(new Section(new Vector3d(x, y, z), halfWidth, halfHeight));
        return this;
    }

    /** Adds a round section. */
    Loft at(double x, double y, double z, double radius) {
        return at(x, y, z, radius, radius);
    }

    /** Adds round sections about an axis along −z, each as z and radius. */
    Loft turned(double x, double y, double... zAndRadius) {
        for (int i = 0; i < zAndRadius.length; i += 2) {
            at(x, y, zAndRadius[i], zAndRadius[i + 1]);
        }
        return this;
    }

    void addTo(Builder mesh) {
        Vector3d[][] rings = new Vector3d[sections.size()][];
        for (int i = 0; i < rings.length; i++) {
            rings[i] = ring(i);
        }
        if (isEdged) {
            for (int i = 0; i + 1 < rings.length; i++) {
                BodyMeshes.band(mesh, row(mesh, rings, i, i, i + 1), row(mesh, rings, i + 1, i, i + 1));
            }
            return;
        }
        int[] below = null;
        for (int i = 0; i < rings.length; i++) {
            int[] row = row(mesh, rings, i, Math.max(0, i - 1), Math.min(rings.length - 1, i + 1));
            if (below != null) {
                BodyMeshes.band(mesh, below, row);
            }
            below = row;
        }
    }

    /** Adds the vertices of a ring whose normals follow from the rings {@code from} to {@code to}. */
    private int[] row(Builder mesh, Vector3d[][] rings, int at, int from, int to) {
        int[] row = new int[sides + 1];
        for (int j = 0; j <= sides; j++) {
            Vector3d n = normal(rings, at, from, to, j);
            Vector3d p = rings[at][j];
            row[j] = mesh.vertex(
                    new double[] {p.x, p.y, p.z},
                    new double[] {n.x, n.y, n.z},
                    j / (double) sides,
                    at / (rings.length - 1.0));
        }
        return row;
    }

    private Vector3d normal(Vector3d[][] rings, int at, int from, int to, int j) {
        Vector3d along = new Vector3d(rings[to][j]).sub(rings[from][j]);
        Vector3d around = around(rings[at], j);
        if (around.lengthSquared() < 1e-16) {
            // A ring that is a point: the direction around it is that of its neighbour.
            around = around(rings[at == from ? to : from], j);
        }
        Vector3d n = around.cross(along);
        return n.lengthSquared() < 1e-20 ? new Vector3d(tangent(at)).mul(at == 0 ? -1 : 1) : n.normalize();
    }

    private Vector3d around(Vector3d[] ring, int j) {
        return new Vector3d(ring[(j + 1) % sides]).sub(ring[(j + sides - 1) % sides]);
    }

    private Vector3d tangent(int at) {
        Vector3d before = sections.get(Math.max(0, at - 1)).centre;
        Vector3d after = sections.get(Math.min(sections.size() - 1, at + 1)).centre;
        Vector3d displacement = new Vector3d(after).sub(before);
        return displacement.lengthSquared() < 1e-12 ? new Vector3d(FORWARD) : displacement.normalize();
    }

    private Vector3d[] ring(int at) {
        Section s = sections.get(at);
        Vector3d along = tangent(at);
        Vector3d right = new Vector3d(along).cross(up).normalize();
        Vector3d upwards = new Vector3d(right).cross(along);
        Vector3d[] ring = new Vector3d[sides + 1];
        for (int j = 0; j <= sides; j++) {
            double angle = 2 * Math.PI * j / sides;
            ring[j] = new Vector3d(s.centre)
                    .fma(s.halfWidth * Superellipsoid.power(Math.sin(angle), roundness), right)
                    .fma(s.halfHeight * Superellipsoid.power(Math.cos(angle), roundness), upwards);
        }
        return ring;
    }

    /**
     * Adds a ring of round section in a plane at right angles to −z, an ellipse about a centre.
     *
     * @param halves half width and height of the ellipse, half the ring's thickness in its plane and along z
     * @param around number of its segments
     */
    static void hoop(Builder mesh, double[] centre, double[] halves, int around) {
        double halfWidth = halves[0];
        double halfHeight = halves[1];
        double thickness = halves[2];
        double depth = halves[3];
        int sides = Math.max(4, around / 4);
        int[] before = null;
        for (int i = 0; i <= around; i++) {
            double angle = -2 * Math.PI * i / around;
            double c = Math.cos(angle);
            double s = Math.sin(angle);
            Vector3d out = new Vector3d(c / halfWidth, s / halfHeight, 0).normalize();
            int[] row = new int[sides + 1];
            for (int j = 0; j <= sides; j++) {
                double turn = 2 * Math.PI * j / sides;
                double outwards = Superellipsoid.power(Math.cos(turn), 0.6);
                double backwards = Superellipsoid.power(Math.sin(turn), 0.6);
                Vector3d n = new Vector3d(out).mul(Math.cos(turn)).add(0, 0, Math.sin(turn));
                double[] p = {
                    centre[0] + halfWidth * c + thickness * outwards * out.x,
                    centre[1] + halfHeight * s + thickness * outwards * out.y,
                    centre[2] + depth * backwards
                };
                row[j] = mesh.vertex(p, new double[] {n.x, n.y, n.z}, 0, 0);
            }
            if (before != null) {
                BodyMeshes.band(mesh, before, row);
            }
            before = row;
        }
    }
}
