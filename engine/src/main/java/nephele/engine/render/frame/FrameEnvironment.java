package nephele.engine.render.frame;

import nephele.engine.level.Environment;
import nephele.engine.scene.View;

/** What follows from a frame's environment for each of its views; derived anew when the environment has changed. */
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

    /** Factor on radiance before the tone curve. */
    public double exposure() {
        return exposure;
    }

    /** What lies behind everything. */
    public ClearColour clearColour() {
        return clearColour;
    }

    /** The same in a view that mirrors tint. */
    public ClearColour clearColour(View view) {
        return clearColour.in(view, environment, output);
    }
}
