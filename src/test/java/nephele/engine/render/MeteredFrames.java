package nephele.engine.render;

import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;

/** Draws small pictures whose exposure is metered, and reads it. */
final class MeteredFrames {
    static final int WIDTH = 128;
    static final int HEIGHT = 72;
    static final RenderSettings HDR = RenderSettings.of(Output.HDR);
    static final Vec3 EYE = Vec3.ZERO;
    static final Vec3 TO_WALL = new Vec3(0, 0, -1);

    private MeteredFrames() {}

    static Renderer load(Offscreen offscreen, Level level) {
        return LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, HDR);
    }

    /** Returns the stops of a view, drawn without history. */
    static double stops(Offscreen offscreen, Level level, RenderSettings settings, View view) {
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            renderer.draw(view, offscreen.picture);
            return renderer.readMeteredStops().orElseThrow();
        }
    }

    /** Draws what a point of the room sees at a time, and returns the stops. */
    static double draw(Offscreen offscreen, Renderer renderer, Vec3 towards, double seconds) {
        FrameState state = FrameState.atStart(renderer.scene().level());
        state.seconds(seconds);
        renderer.draw(offscreen.view(EYE, towards), state, offscreen.picture);
        offscreen.gl.requireNoError("frame");
        return renderer.readMeteredStops().orElseThrow();
    }
}
