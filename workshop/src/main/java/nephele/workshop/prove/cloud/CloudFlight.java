package nephele.workshop.prove.cloud;

import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Environment;
import nephele.engine.math.Vec3;
import nephele.engine.measure.Flip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.CloudHistory;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;

/**
 * Frames of a flight through clouds, 60 a second: by a quality that uses earlier frames, and by one that does not. Pictures are
 * linear light as displayed at exposure 0.
 */
final class CloudFlight implements AutoCloseable {
    private static final double FRAMES_A_SECOND = 60;

    private final Path path;
    private final RenderTarget picture;
    private final Renderer shared;
    private final Renderer converged;
    private final FrameState state;
    private final Environment environment;

    /** A way at one altitude, towards −z, whose view looks a little up and turns to the left. */
    record Path(Vec3 from, double metresPerSecond, double degreesPerSecond) {
        private static final double RISE = 0.15;

        View view(int frame, double aspect) {
            double seconds = frame / FRAMES_A_SECOND;
            double angle = Math.toRadians(degreesPerSecond * seconds);
            Vec3 eye = from.plus(new Vec3(0, 0, -metresPerSecond * seconds));
            Vec3 ahead = new Vec3(-Math.sin(angle), RISE, -Math.cos(angle));
            return Viewpoints.between(eye, eye.plus(ahead), null, aspect);
        }
    }

    /** The size of pictures in pixels. */
    record Size(int width, int height) {}

    /** Compares with frames of all rays. */
    CloudFlight(GlContext gl, OpenedLevel level, Path path, Quality quality, Size size) {
        this(gl, level, path, quality, quality.with("cloudHistory", CloudHistory.NONE), size);
    }

    /** @param whole quality of the frames that are compared with */
    CloudFlight(GlContext gl, OpenedLevel level, Path path, Quality quality, Quality whole, Size size) {
        this.path = path;
        picture = RenderTarget.picture(gl, "flight", PixelFormat.RGBA8, size.width, size.height);
        shared = renderer(gl, level, quality);
        converged = renderer(gl, level, whole);
        state = FrameState.atStart(level.level());
        environment = level.level().environment();
    }

    private static Renderer renderer(GlContext gl, OpenedLevel level, Quality quality) {
        return LevelRenderer.load(
                gl, level.level(), level.assets(), RenderSettings.of(Output.HDR, quality.with("pictureResolution", 1)));
    }

    View view(int frame) {
        return path.view(frame, picture.width() / (double) picture.height());
    }

    /** Draws a frame after those before it. */
    LinearPicture seen(int frame) {
        return drawn(shared, frame);
    }

    /** Draws a frame that uses no others. */
    LinearPicture reference(int frame) {
        return drawn(converged, frame);
    }

    /** Forgets all frames. */
    void cut() {
        shared.forget();
    }

    private LinearPicture drawn(Renderer renderer, int frame) {
        state.seconds(frame / FRAMES_A_SECOND);
        renderer.draw(view(frame), state, picture);
        float[] light = renderer.readRadiance();
        for (int i = 0; i < light.length; i++) {
            light[i] = (float) ToneMapping.toneCurve(light[i], environment.toneCurve());
        }
        return new LinearPicture(picture.width(), picture.height(), light);
    }

    static double flip(LinearPicture reference, LinearPicture test) {
        return Flip.ofDisplayed(reference, test).mean();
    }

    @Override
    public void close() {
        shared.close();
        converged.close();
        picture.close();
    }
}
