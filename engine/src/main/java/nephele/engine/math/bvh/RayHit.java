package nephele.engine.math.bvh;

/** The nearest hit of a ray query, reused by its owner for every query. */
public final class RayHit {
    private int item = -1;
    private double distance = Double.POSITIVE_INFINITY;

    /** Clears the hit; only hits up to {@code limit} count. */
    public void reset(double limit) {
        item = -1;
        distance = limit;
    }

    /** Keeps the nearer hit, the lower item of two equally near ones; independent of the order of calls. */
    public void offer(int candidate, double candidateDistance) {
        boolean nearer = candidateDistance < distance;
        boolean tie = candidateDistance == distance && (item < 0 || candidate < item);
        if (nearer || tie) {
            item = candidate;
            distance = candidateDistance;
        }
    }

    /** Returns the item hit, −1 for none. */
    public int item() {
        return item;
    }

    /** Returns the ray parameter: metres for a direction of unit length. */
    public double distance() {
        return distance;
    }
}
