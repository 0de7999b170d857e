package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Environment;
import nephele.engine.math.Vec3;
import nephele.engine.measure.Flip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;

/**
 * Frames of a flight through clouds, 60 a second: by a quality that uses earlier frames, and by one that does not.
 * Pictures are linear light as displayed at exposure 0.
 */
final class CloudFlight implements AutoCloseable {
    private static final double FRAMES_A_SECOND = 60;

    /** FLIP by which a step may be greater than that of the reference. */
    private static final double MOST_STEP = 0.02;

    private final Path path;
    private final RenderTarget picture;
    private final Renderer shared;
    private final Renderer converged;
    private final FrameState state;
    private final Environment environment;
    private final List<String> failures = new ArrayList<>();
    private LinearPicture lastReference;
    private LinearPicture last;
    private int frames;
    private double sum;
    private double worst;
    private double beyond = Double.NEGATIVE_INFINITY;

    /** A path at one altitude, towards −z, whose view looks a little up and turns to the left. */
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

    /**
     * @param picture in whose size frames are drawn
     * @param whole quality of the frames that are compared with
     */
    CloudFlight(GlContext gl, RenderTarget picture, OpenedLevel level, Path path, Quality quality, Quality whole) {
        this.path = path;
        this.picture = picture;
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

    /**
     * Draws the next frame by both qualities and measures its error, and by how much its step from the frame before is
     * greater than that of the reference.
     */
    void fly() {
        LinearPicture ofReference = reference(frames);
        LinearPicture now = drawn(frames);
        double error = flip(ofReference, now);
        sum += error;
        worst = Math.max(worst, error);
        if (frames > 0) {
            double step = flip(last, now) - flip(lastReference, ofReference);
            beyond = Math.max(beyond, step);
            if (!(step <= MOST_STEP)) {
                failures.add(String.format(Locale.ROOT, "frame %d: step %.4f beyond", frames, step));
            }
        }
        lastReference = ofReference;
        last = now;
        frames++;
    }

    LinearPicture last() {
        return last;
    }

    LinearPicture lastReference() {
        return lastReference;
    }

    double meanError() {
        return sum / frames;
    }

    double worstError() {
        return worst;
    }

    /** Returns by how much the greatest step is above that of the reference. */
    double beyond() {
        return beyond;
    }

    /** Returns the steps that are too great, in words. */
    List<String> failures() {
        return failures;
    }

    /** Draws a frame after those before it. */
    LinearPicture drawn(int frame) {
        return draw(shared, frame);
    }

    /** Draws a frame that uses no others. */
    LinearPicture reference(int frame) {
        return draw(converged, frame);
    }

    /** Forgets all frames. */
    void cut() {
        shared.forget();
    }

    private LinearPicture draw(Renderer renderer, int frame) {
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
    }
}
