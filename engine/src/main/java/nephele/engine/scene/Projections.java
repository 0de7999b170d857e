package nephele.engine.scene;

import java.util.Arrays;

/**
 * The projections of views through portals: a frame's own with the near plane pushed away. Distances go in steps, so that
 * whoever draws frame after frame makes each of them once.
 */
final class Projections {
    private static final int STEPS_PER_DOUBLE = 16;
    private static final double LOG_2 = Math.log(2);

    private final Projection[] pushed = new Projection[20 * STEPS_PER_DOUBLE];
    private Projection main;

    /** Forgets what belongs to another picture. */
    void begin(Projection newMain) {
        if (!newMain.equals(main)) {
            main = newMain;
            Arrays.fill(pushed, null);
        }
    }

    /** The one with its near plane as far away as a step below {@code metres}, or as {@code before} has it. */
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
