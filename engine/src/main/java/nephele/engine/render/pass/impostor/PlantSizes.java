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

    /** Returns true if all plants of up to a size have impostors alone. */
    boolean isImpostor(double mostPixels) {
        return mostPixels < begin * (1 - MARGIN);
    }

    /** Returns true if all plants from a size on are meshes alone. */
    boolean isMesh(double leastPixels) {
        return leastPixels > FADE * begin * (1 + MARGIN);
    }
}
