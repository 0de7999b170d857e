package nephele.engine.render.pass.rim;

import nephele.engine.math.Vec3;

/**
 * The colours of the level's pairs of portals, linear RGB as displayed: hues away from the blue and orange of the shots,
 * and far from each other for any number of pairs.
 */
final class RimColours {
    private static final double GOLDEN_SHARE = 0.6180339887498949;
    /** Share of the hues between blue and orange that are greens; these are used first. */
    private static final double GREENS = 0.45;

    private RimColours() {}

    /**
     * Returns the colour of a pair.
     *
     * @param pair index among the level's pairs, with gaps
     */
    static Vec3 ofPair(int pair) {
        double place = 0.2 + GOLDEN_SHARE * pair;
        place -= Math.floor(place);
        return hue(place < GREENS ? 0.24 + 0.24 * place / GREENS : 0.72 + 0.25 * (place - GREENS) / (1 - GREENS));
    }

    /** Returns a bright, slightly unsaturated colour. */
    private static Vec3 hue(double turns) {
        return new Vec3(channel(turns), channel(turns + 2 / 3.0), channel(turns + 1 / 3.0));
    }

    private static double channel(double turns) {
        double wave = 0.5 + 0.5 * Math.cos(2 * Math.PI * turns);
        return 0.06 + 0.84 * wave * wave;
    }
}
