package nephele.engine.collision;

import java.util.Arrays;
import java.util.List;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;

/**
 * A collider in the form that contact generation needs: corners, faces as rings of corners, the planes through each
 * face's edges perpendicular to the face, and every edge direction once. All are relative to the collider's centre.
 */
public final class ContactHull {
    private static final double PARALLEL_SINE_SQUARED = 1e-9;

    private final double[] corners;
    private final double[] planes;
    private final int[] ringStart;
    private final int[] ring;
    /**
     * Four numbers for each place of a ring: the outward unit normal of the edge that starts there, and its distance.
     */
    private final double[] sides;

    private final double[] edges;
    private final boolean uprightBox;
    private final double[] halfSize = new double[3];

    ContactHull(Collider collider) {
        ConvexPolyhedron shape = collider.shape();
        corners = collider.vertices();
        planes = collider.planes();
        ringStart = starts(shape.faces());
        ring = rings(shape);
        sides = new double[4 * ring.length];
        for (int face = 0; face < faces(); face++) {
            for (int place = ringStart[face]; place < ringStart[face + 1]; place++) {
                writeSide(face, place);
            }
        }
        edges = directions();
        uprightBox = isUprightBox();
        for (int axis = 0; axis < 3; axis++) {
            for (int i = axis; i < corners.length; i += 3) {
                halfSize[axis] = Math.max(halfSize[axis], corners[i]);
            }
        }
    }

    private static int[] starts(List<ConvexPolyhedron.Face> faces) {
        int[] starts = new int[faces.size() + 1];
        for (int i = 0; i < faces.size(); i++) {
            starts[i + 1] = starts[i] + faces.get(i).polygon().size();
        }
        return starts;
    }

    private static int[] rings(ConvexPolyhedron shape) {
        return shape.faces().stream()
                .flatMapToInt(face -> face.polygon().stream().mapToInt(p -> nearest(shape.vertices(), p)))
                .toArray();
    }

    private static int nearest(List<Vec3> corners, Vec3 p) {
        int at = corners.indexOf(p);
        for (int i = 0; at < 0 && i < corners.size(); i++) {
            Vec3 c = corners.get(i);
            at = Math.abs(c.x() - p.x()) + Math.abs(c.y() - p.y()) + Math.abs(c.z() - p.z()) < 1e-6 ? i : -1;
        }
        return Math.max(at, 0);
    }

    private void writeSide(int face, int place) {
        int next = place + 1 == ringStart[face + 1] ? ringStart[face] : place + 1;
        int a = 3 * ring[place];
        int b = 3 * ring[next];
        double dX = corners[b] - corners[a];
        double dY = corners[b + 1] - corners[a + 1];
        double dZ = corners[b + 2] - corners[a + 2];
        double x = dY * planes[4 * face + 2] - dZ * planes[4 * face + 1];
        double y = dZ * planes[4 * face] - dX * planes[4 * face + 2];
        double z = dX * planes[4 * face + 1] - dY * planes[4 * face];
        double length = Math.sqrt(x * x + y * y + z * z);
        int at = 4 * place;
        sides[at] = x / length;
        sides[at + 1] = y / length;
        sides[at + 2] = z / length;
        sides[at + 3] = (x * corners[a] + y * corners[a + 1] + z * corners[a + 2]) / length;
    }

    private double[] directions() {
        double[] found = new double[3 * ring.length];
        int count = 0;
        for (int face = 0; face < faces(); face++) {
            for (int place = ringStart[face]; place < ringStart[face + 1]; place++) {
                int next = place + 1 == ringStart[face + 1] ? ringStart[face] : place + 1;
                double x = corners[3 * ring[next]] - corners[3 * ring[place]];
                double y = corners[3 * ring[next] + 1] - corners[3 * ring[place] + 1];
                double z = corners[3 * ring[next] + 2] - corners[3 * ring[place] + 2];
                double length = Math.sqrt(x * x + y * y + z * z);
                found[3 * count] = x / length;
                found[3 * count + 1] = y / length;
                found[3 * count + 2] = z / length;
                count += isNew(found, count) ? 1 : 0;
            }
        }
        return Arrays.copyOf(found, 3 * count);
    }

    private static boolean isNew(double[] found, int at) {
        for (int i = 0; i < at; i++) {
            double x = found[3 * i + 1] * found[3 * at + 2] - found[3 * i + 2] * found[3 * at + 1];
            double y = found[3 * i + 2] * found[3 * at] - found[3 * i] * found[3 * at + 2];
            double z = found[3 * i] * found[3 * at + 1] - found[3 * i + 1] * found[3 * at];
            if (x * x + y * y + z * z < PARALLEL_SINE_SQUARED) {
                return false;
            }
        }
        return true;
    }

    private boolean isUprightBox() {
        boolean upright = faces() == 6 && corners.length == 24;
        for (int face = 0; face < faces(); face++) {
            double most = Math.max(
                    Math.abs(planes[4 * face]),
                    Math.max(Math.abs(planes[4 * face + 1]), Math.abs(planes[4 * face + 2])));
            upright &= most == 1;
        }
        return upright;
    }

    /** Returns true for a box aligned with the world axes, which {@link #halfSize} describes completely. */
    public boolean uprightBox() {
        return uprightBox;
    }

    public double halfSize(int axis) {
        return halfSize[axis];
    }

    public int corners() {
        return corners.length / 3;
    }

    public double corner(int corner, int axis) {
        return corners[3 * corner + axis];
    }

    public int faces() {
        return planes.length / 4;
    }

    /** Returns a component of a face's plane: 0–2 the outward unit normal, 3 its distance from the centre. */
    public double plane(int face, int component) {
        return planes[4 * face + component];
    }

    /** Returns the first place of a face's ring; the ring ends before the first place of the next face. */
    public int ringStart(int face) {
        return ringStart[face];
    }

    /** Returns the corner at a place of the rings. */
    public int ring(int place) {
        return ring[place];
    }

    /**
     * Returns a component for the edge that starts at a place: 0–2 its unit normal, in the plane of the face and
     * pointing out of it, 3 its distance.
     */
    public double side(int place, int component) {
        return sides[4 * place + component];
    }

    public int edges() {
        return edges.length / 3;
    }

    /** Returns a component of an edge's unit direction; parallel edges share one direction. */
    public double edge(int edge, int axis) {
        return edges[3 * edge + axis];
    }
}
