package nephele.host.compare;

import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Environment;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.measure.FrameTimes;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;

/** One of two techniques: its renderer, its whole picture, and the times of its last frames. */
final class ComparedSide implements AutoCloseable {
    private static final int TIMED_FRAMES = 31;

    private final GlContext gl;
    private final long[] nanos = new long[TIMED_FRAMES];
    /** Timed frames; −1 before the first one, in which programs are compiled and clouds sampled. */
    private long frames = -1;

    private Renderer renderer;
    private Environment environment;
    private RenderTarget picture;

    ComparedSide(GlContext gl, Scene scene, RenderSettings settings) {
        this.gl = gl;
        renderer = LevelRenderer.load(gl, scene, settings);
    }

    /** Follows an edit, whose frames have other times. */
    void edit(Scene scene) {
        renderer = LevelRenderer.edited(renderer, scene);
        environment = null;
        frames = -1;
    }

    Renderer renderer() {
        return renderer;
    }

    RenderTarget picture() {
        return picture;
    }

    /** Draws the whole view, of any level with the same sun and clouds, and waits until that is done. */
    void draw(View view, FrameState state, int width, int height, StepListener listener) {
        prepare(width, height);
        Environment before = state.environment();
        state.environment(at(state.seconds()));
        gl.finish();
        long start = System.nanoTime();
        renderer.draw(view, state, picture, listener);
        gl.finish();
        if (frames >= 0) {
            nanos[(int) (frames % TIMED_FRAMES)] = System.nanoTime() - start;
        }
        frames++;
        state.environment(before);
    }

    /** Returns this side's environment: samples of clouds are kept only for the one that they were made for. */
    private Environment at(double seconds) {
        Environment authored = renderer.scene().level().environment();
        if (environment == null || Daylight.moves(authored)) {
            Environment now = Daylight.at(authored, seconds);
            environment = now.equals(environment) ? environment : now;
        }
        return environment;
    }

    private void prepare(int width, int height) {
        boolean fits = picture != null && picture.width() == width && picture.height() == height;
        if (!fits) {
            closePicture();
            picture = RenderTarget.picture(gl, "compared picture", PixelFormat.RGBA8, width, height);
        }
    }

    /** Returns the median time of a frame in milliseconds; 0 before the second. */
    double medianMillis() {
        int count = (int) Math.min(frames, TIMED_FRAMES);
        return count <= 0 ? 0 : FrameTimes.percentileMs(nanos, count, 0.5);
    }

    private void closePicture() {
        if (picture != null) {
            picture.close();
            picture = null;
        }
    }

    @Override
    public void close() {
        closePicture();
        renderer.close();
    }
}
