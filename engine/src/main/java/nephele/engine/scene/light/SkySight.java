package nephele.engine.scene.light;

/** Answers whether the half-line from {@code o} along {@code d} meets an item other than {@code except}. */
@FunctionalInterface
interface SkySight {
    boolean isOccluded(double[] o, double[] d, int except);
}
