package nephele.engine.render.pass.rim;

import nephele.engine.math.Vec3;

/**
 * The colours of portals, linear RGB as displayed. The two shots differ to every eye: blue and orange, and their
 * patterns differ too. Pairs of the level take hues away from both, and far from one another however many
 * there are.
 */
public final class RimColours {
    private static final Vec3 FIRST = new Vec3(0.05, 0.42, 1);
    private static final Vec3 SECOND = new Vec3(1, 0.36, 0.03);
    private static final double GOLDEN_SHARE = 0.6180339887498949;
    /** Of the hues between blue and orange, the greens come first. */
    private static final double GREENS = 0.45;

    private RimColours() {}

    /** @param shot 0 or 1 */
    public static Vec3 ofShot(int shot) {
        return shot == 0 ? FIRST : SECOND;
    }

    /** @param pair counts the pairs of a level, some left out */
    static Vec3 ofPair(int pair) {
        double place = 0.2 + GOLDEN_SHARE * pair;
        place -= Math.floor(place);
        return hue(place < GREENS ? 0.24 + 0.24 * place / GREENS : 0.72 + 0.25 * (place - GREENS) / (1 - GREENS));
    }

    /** A clear, not quite saturated colour. */
    private static Vec3 hue(double turns) {
        return new Vec3(channel(turns), channel(turns + 2 / 3.0), channel(turns + 1 / 3.0));
    }

    private static double channel(double turns) {
        double wave = 0.5 + 0.5 * Math.cos(2 * Math.PI * turns);
        return 0.06 + 0.84 * wave * wave;
    }
}
