package nephele.editor.draw;

/**
 * How far the bake of a level's light is.
 *
 * @param fraction of the stage that is done, 0–1
 * @param secondsLeft of the stage
 */
public record LightProgress(Stage stage, double fraction, double secondsLeft) {
    /** No bake runs. */
    public static final LightProgress NONE = new LightProgress(Stage.NONE, 0, 0);

    /** The part of the bake that runs. */
    public enum Stage {
        NONE,
        /** Everything along few rays. */
        COARSE,
        /** Block after block along many. */
        FINE
    }

    /** Returns the progress of a stage that began some time ago and goes on as fast. */
    static LightProgress since(long beganNanos, Stage stage, double fraction) {
        double seconds = (System.nanoTime() - beganNanos) * 1e-9;
        return new LightProgress(stage, fraction, fraction > 0 ? seconds * (1 - fraction) / fraction : 0);
    }
}
