package nephele.scenes.view;

/**
 * The movement that the keys request, in the plane of the view: a direction of length 1, or none. Diagonals are no
 * faster than the axes.
 *
 * @param right component of the direction to the right
 * @param ahead component of the direction along the view
 * @param unitsPerSecond 0 if no movement key is held
 */
public record Steering(double right, double ahead, double unitsPerSecond) {
    static final Steering NONE = new Steering(0, 0, 0);

    public Steering {
        double length = Math.sqrt(right * right + ahead * ahead);
        boolean moves = length > 0 && length < Double.POSITIVE_INFINITY && isSpeed(unitsPerSecond);
        right = moves ? right / length : 0;
        ahead = moves ? ahead / length : 0;
        unitsPerSecond = moves ? unitsPerSecond : 0;
    }

    private static boolean isSpeed(double unitsPerSecond) {
        return unitsPerSecond > 0 && unitsPerSecond < Double.POSITIVE_INFINITY;
    }

    boolean moves() {
        return unitsPerSecond > 0;
    }
}
