package nephele.engine.render.pass.impostor;

/**
 * The sizes at which plants are drawn as meshes and as impostors.
 *
 * @param begin pixels below which only impostors are drawn; 0 for meshes alone
 */
record PlantSizes(double begin) {
    /** As {@code PLANT_FADE} in {@code plant-fade.glsl}. */
    private static final double FADE = 1.2;

    /** More than floats err. */
    private static final double MARGIN = 1e-4;

    /** As {@code PLANT_THIN} and {@code PLANT_SHRINK} in {@code plant-fade.glsl}. */
    private static final double THIN_PIXELS = 8;

    private static final double SHRINK = 0.25;

    /** Returns how many of a cluster's plants are drawn, the first ones. @param mostPixels of the largest */
    static int drawn(int plants, double mostPixels) {
        double share = (1 + SHRINK / 2) * Math.min(1, mostPixels / THIN_PIXELS) + SHRINK / 2;
        return (int) Math.min(plants, Math.ceil(plants * share));
    }

    /** Returns true if all plants of up to a size have impostors alone. */
    boolean isImpostor(double mostPixels) {
        return mostPixels < begin * (1 - MARGIN);
    }

    /** Returns true if all plants from a size on are meshes alone. */
    boolean isMesh(double leastPixels) {
        return leastPixels > FADE * begin * (1 + MARGIN);
    }
}
