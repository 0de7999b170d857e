package nephele.engine.sim.player;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The planes hit during one move; removes from a vector the components that lead into them. */
final class ContactPlanes {
    private static final int CAPACITY = 8;
    private static final double TOLERANCE = 1e-10;
    private static final double PARALLEL_SQUARE = 1e-14;

    private final Vector3d[] normals = new Vector3d[CAPACITY];
    private final Vector3d candidate = new Vector3d();
    private final Vector3d best = new Vector3d();
    private int size;

    ContactPlanes() {
        for (int i = 0; i < CAPACITY; i++) {
            normals[i] = new Vector3d();
        }
    }

    void clear() {
        size = 0;
    }

    void add(Vector3dc unitNormal) {
        if (size < CAPACITY) {
            normals[size++].set(unitNormal);
        }
    }

    int size() {
        return size;
    }

    Vector3dc normal(int i) {
        return normals[i];
    }

    /**
     * Replaces {@code v} by the nearest vector that leads into none of the planes: of its projections onto one plane
     * and onto the crease of two, the longest that is allowed, else zero. The longest is the nearest, as all are
     * projections of the same vector.
     */
    void removeComponentsInto(Vector3d v) {
        if (isAllowed(v)) {
            return;
        }
        best.zero();
        for (int i = 0; i < size; i++) {
            Vector3d n = normals[i];
            double into = v.dot(n);
            candidate.set(v.x - n.x * into, v.y - n.y * into, v.z - n.z * into);
            keepLonger();
            for (int j = 0; j < i; j++) {
                crease(v, n, normals[j]);
            }
        }
        v.set(best);
    }

    private void crease(Vector3d v, Vector3d a, Vector3d b) {
        a.cross(b, candidate);
        double square = candidate.lengthSquared();
        if (square > PARALLEL_SQUARE) {
            candidate.mul(candidate.dot(v) / square);
            keepLonger();
        }
    }

    private void keepLonger() {
        if (candidate.lengthSquared() > best.lengthSquared() && isAllowed(candidate)) {
            best.set(candidate);
        }
    }

    private boolean isAllowed(Vector3d v) {
        double tolerated = -TOLERANCE * v.length();
        for (int i = 0; i < size; i++) {
            if (v.dot(normals[i]) < tolerated) {
                return false;
            }
        }
        return true;
    }
}
