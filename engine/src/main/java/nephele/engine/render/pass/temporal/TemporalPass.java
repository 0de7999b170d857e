package nephele.engine.render.pass.temporal;

import java.util.List;
import java.util.Set;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms.Vector2;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.resource.PictureHistory;
import nephele.engine.scene.Reprojection;

/**
 * Averages the displayed picture with those of the frames before, which have seen other points of each pixel, and scales it
 * up; exists only if quality requests it.
 */
public final class TemporalPass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("temporal", Stage.AFTER_ALL, TemporalPass::requiredBy).using(PictureHistory.RESOURCE);

    /** The alpha of what is held before the eye, which stays where it is in the picture. */
    public static final int IN_HAND = -1024;

    /** The distance from a pixel's centre at which a point has no weight. */
    public static final double REACH_PIXELS = 0.8;

    /** The weight of frames that have seen all points. */
    public static final int ALL_POINTS = 32;

    private static final int PLACES = 16;

    private static final String FOLDER = "/nephele/engine/render/pass/temporal/";

    private final GlContext gl;
    private final PictureHistory history;
    private final FullScreenDrawing drawing;
    private final AccumulationUniforms uniforms;
    /**
     * The averages up to this frame and up to the one before, each as displayed and as later frames read it; {@code null}
     * before the first frame.
     */
    private final RenderTarget[] averages = new RenderTarget[2];

    /** @param course see the shader */
    private record AccumulationUniforms(
            Vector2 pixelsOfDrawn,
            Vector2 shift,
            Vector3 course,
            Vector4 acrossBefore,
            Vector4 upBefore,
            Vector4 aheadBefore) {}

    private TemporalPass(LoadContext context) {
        gl = context.gl();
        history = context.get(PictureHistory.RESOURCE);
        context.own(this::closeAverages);
        drawing =
                new FullScreenDrawing(context, Defines.of(context), FOLDER + "temporal.vert", FOLDER + "temporal.frag");
        uniforms = drawing.uniforms(AccumulationUniforms.class);
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.isAccumulated() ? List.of(new Required("quality: antialiasing", TemporalPass::new)) : List.of();
    }

    @Override
    public Set<Target> reads() {
        return Set.of(Target.SURFACE);
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.PICTURE);
    }

    @Override
    public void draw(FrameContext frame) {
        RenderTarget picture = frame.picture();
        boolean isFirst = fit(picture) || history.isFirst();
        RenderTarget before = averages[0];
        averages[0] = averages[1];
        averages[1] = before;
        uniforms.shift().set(history.acrossPixels(), history.upPixels());
        double across = (double) picture.width() / frame.surface().width();
        double up = (double) picture.height() / frame.surface().height();
        uniforms.pixelsOfDrawn().set(across, up);
        uniforms.course()
                .set(
                        isFirst ? 1 : 0,
                        history.framesAtRest(),
                        ALL_POINTS / (PictureHistory.POINTS * meanWeight(across, up)));
        Reprojection reprojection = history.reprojection();
        put(uniforms.acrossBefore(), reprojection, 0);
        put(uniforms.upBefore(), reprojection, 1);
        put(uniforms.aheadBefore(), reprojection, 2);
        frame.surface().colour().bind(TextureUnit.COLOURS);
        before.second().bind(TextureUnit.HISTORY);
        drawing.draw(averages[0], Depth.OFF);
        averages[0].copyTo(picture);
    }

    /** Returns the mean weight of a drawn pixel, by the places in it of a pixel's centre. */
    private static double meanWeight(double across, double up) {
        double sum = 0;
        for (int i = 0; i < PLACES * PLACES; i++) {
            double x = across * ((i % PLACES + 0.5) / PLACES - 0.5);
            double y = up * ((i / PLACES + 0.5) / PLACES - 0.5);
            double fall = Math.max(1 - (x * x + y * y) / (REACH_PIXELS * REACH_PIXELS), 0);
            sum += fall * fall;
        }
        return sum / (PLACES * PLACES);
    }

    private static void put(Vector4 uniform, Reprojection map, int row) {
        uniform.set(map.factor(row, 0), map.factor(row, 1), map.factor(row, 2), map.factor(row, 3));
    }

    /** Returns true if the averages are new. */
    private boolean fit(RenderTarget picture) {
        RenderTarget known = averages[0];
        if (known != null && known.width() == picture.width() && known.height() == picture.height()) {
            return false;
        }
        closeAverages();
        for (int i = 0; i < averages.length; i++) {
            averages[i] = RenderTarget.pair(
                    gl,
                    "average of frames",
                    PixelFormat.RGBA8,
                    PixelFormat.RGBA16F,
                    picture.width(),
                    picture.height(),
                    Sampling.LINEAR_CLAMP);
        }
        return true;
    }

    private void closeAverages() {
        for (RenderTarget average : averages) {
            if (average != null) {
                average.close();
            }
        }
    }
}
