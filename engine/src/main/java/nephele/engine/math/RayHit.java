package nephele.engine.math;

/** The nearest hit of a ray query; its owner uses it again for every query. */
public final class RayHit {
    private int item = -1;
    private double distance = Double.POSITIVE_INFINITY;

    /** No hit yet; only those up to {@code limit} count. */
    void reset(double limit) {
        item = -1;
        distance = limit;
    }

    /** Takes the nearer hit, and of two equally near ones the lower item, whatever the order they are found in. */
    public void offer(int candidate, double candidateDistance) {
        boolean nearer = candidateDistance < distance;
        boolean tie = candidateDistance == distance && (item < 0 || candidate < item);
        if (nearer || tie) {
            item = candidate;
            distance = candidateDistance;
        }
    }

    /** −1 when nothing was hit. */
    public int item() {
        return item;
    }

    /** Ray parameter: metres for a direction of unit length. */
    public double distance() {
        return distance;
    }
}
