package nephele.engine.render.frame;

import nephele.engine.level.Environment;
import nephele.engine.scene.View;

/** Values derived from a frame's environment for all views; derived again when the environment has changed. */
public final class FrameEnvironment {
    private final Output output;
    private Environment environment;
    private ClearColour clearColour;
    private double exposure;

    FrameEnvironment(Output output) {
        this.output = output;
    }

    void follow(Environment now) {
        if (now != environment) {
            environment = now;
            clearColour = ClearColour.of(now, output);
            exposure = ClearColour.exposure(now);
        }
    }

    /** Returns the factor on radiance before the tone curve; 1 for auto, which is metered. */
    public double exposure() {
        return exposure;
    }

    /** Returns the colour behind everything. */
    public ClearColour clearColour() {
        return clearColour;
    }

    /** Returns the colour behind everything in a view that mirrors tint. */
    public ClearColour clearColour(View view) {
        return clearColour.in(view, environment, output);
    }
}
