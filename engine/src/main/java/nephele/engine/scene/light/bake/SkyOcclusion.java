package nephele.engine.scene.light.bake;

/** Tests if the ray from {@code o} along {@code d} intersects an item other than {@code except}. */
@FunctionalInterface
interface SkyOcclusion {
    boolean isOccluded(double[] o, double[] d, int except);
}
