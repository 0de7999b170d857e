package nephele.engine.scene;

import java.util.Arrays;

/**
 * The projections of views through openings: the frame's own projection with the near plane moved away. The distances
 * are quantised to 16 steps per doubling, so that each projection is made once and reused in later frames.
 */
final class Projections {
    private static final int STEPS_PER_DOUBLE = 16;
    private static final double LOG_2 = Math.log(2);

    private final Projection[] pushed = new Projection[20 * STEPS_PER_DOUBLE];
    private Projection main;

    /** Clears the cache if the main projection has changed. */
    void begin(Projection newMain) {
        if (!newMain.equals(main)) {
            main = newMain;
            Arrays.fill(pushed, null);
        }
    }

    /**
     * Returns the projection with its near plane at the greatest step not beyond {@code metres}, or {@code before} if
     * that has its near plane at least as far away.
     */
    Projection pushed(Projection before, double metres) {
        double doubles = Math.log(metres / main.nearMetres()) / LOG_2;
        int step = (int) Math.floor(Math.min(doubles * STEPS_PER_DOUBLE, pushed.length - 1));
        if (step <= 0 || atStep(step).nearMetres() <= before.nearMetres()) {
            return before;
        }
        return atStep(step);
    }

    private Projection atStep(int step) {
        if (pushed[step] == null) {
            double near = main.nearMetres() * Math.pow(2, step / (double) STEPS_PER_DOUBLE);
            pushed[step] = new Projection(main.verticalFovRadians(), main.aspect(), near, main.farMetres());
        }
        return pushed[step];
    }
}
