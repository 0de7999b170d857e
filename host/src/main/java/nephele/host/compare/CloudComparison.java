package nephele.host.compare;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Supplier;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;

/**
 * Draws a view by two techniques, one left and one right of a wipe. Each draws the whole view in every frame, and the one
 * that begins alternates, so that their times can be compared. Their difference is measured twice a second from small
 * copies, on a thread of its own.
 */
public final class CloudComparison implements AutoCloseable {
    /** The width of the copies that are measured. */
    public static final int MEASURED_WIDTH = 320;

    private static final long INTERVAL_NANOS = 500_000_000L;

    private final GlContext gl;
    private final TechniquePair techniques;
    private final ComparedSide left;
    private final ComparedSide right;
    private final ExecutorService worker = Executors.newSingleThreadExecutor(CloudComparison::thread);
    private RenderTarget small;
    private Future<PictureDifference> measuring;
    private ComparisonFigures figures = new ComparisonFigures(0, 0, null);
    private long measuredNanos;
    private long frames;

    private CloudComparison(GlContext gl, TechniquePair techniques, ComparedSide left, ComparedSide right) {
        this.gl = gl;
        this.techniques = techniques;
        this.left = left;
        this.right = right;
    }

    /**
     * Builds the renderers of both sides, which share all that does not depend on clouds.
     *
     * @param settings with output HDR
     */
    public static CloudComparison load(GlContext gl, ComparedScenes scenes, RenderSettings settings) {
        ComparedSide left = new ComparedSide(gl, scenes.left(), settings);
        try {
            return new CloudComparison(gl, scenes.techniques(), left, new ComparedSide(gl, scenes.right(), settings));
        } catch (RuntimeException e) {
            left.close();
            throw e;
        }
    }

    /** The same level for each of two techniques. */
    public record ComparedScenes(TechniquePair techniques, Scene left, Scene right) {
        /** Returns the scenes of a level all whose clouds each technique draws. */
        public static ComparedScenes ofAllClouds(Scene scene, TechniquePair techniques) {
            return new ComparedScenes(
                    techniques, drawnBy(scene, techniques.left()), drawnBy(scene, techniques.right()));
        }

        private static Scene drawnBy(Scene scene, CloudTechnique technique) {
            PlacedLevel placed =
                    new PlacedLevel(TechniquePair.drawnBy(scene.level(), technique), scene.assets(), scene.statics());
            return scene.edited(placed, scene.light());
        }
    }

    private static Thread thread(Runnable task) {
        Thread thread = new Thread(task, "comparison");
        thread.setDaemon(true);
        thread.setPriority(Thread.MIN_PRIORITY);
        return thread;
    }

    public TechniquePair techniques() {
        return techniques;
    }

    /** Returns the left side's renderer, which stays this object's. */
    public Renderer leftRenderer() {
        return left.renderer();
    }

    /** Follows an edit of the level; the techniques stay. */
    public void edit(ComparedScenes scenes) {
        left.edit(scenes.left());
        right.edit(scenes.right());
    }

    /** Draws a frame of both sides into their own pictures; {@code listener} hears the steps of the left one. */
    public void draw(View view, FrameState state, int width, int height, StepListener listener) {
        if (width == 0 || height == 0) {
            return;
        }
        boolean beginsLeft = frames++ % 2 == 0;
        if (beginsLeft) {
            left.draw(view, state, width, height, listener);
        }
        right.draw(view, state, width, height, StepListener.NONE);
        if (!beginsLeft) {
            left.draw(view, state, width, height, listener);
        }
        measure();
    }

    /** Copies the sides of the last frame to their parts of a picture of the same size. */
    public void compose(Wipe wipe, RenderTarget picture) {
        int width = picture.width();
        int height = picture.height();
        if (width == 0 || height == 0) {
            return;
        }
        int column = wipe.column(width);
        DrawState state = gl.state();
        if (column > 0) {
            state.scissor(0, 0, column, height);
            left.picture().copyTo(picture);
        }
        if (column < width) {
            state.scissor(column, 0, width - column, height);
            right.picture().copyTo(picture);
        }
        state.noScissor();
    }

    /** Returns the picture of a side's last frame, which stays this object's. */
    public RenderTarget leftPicture() {
        return left.picture();
    }

    /** Returns the picture of the other side's last frame, which stays this object's. */
    public RenderTarget rightPicture() {
        return right.picture();
    }

    private void measure() {
        if (measuring != null && measuring.isDone()) {
            figures = figures(result(measuring));
            measuring = null;
        }
        long now = System.nanoTime();
        if (measuring == null && (frames == 1 || now - measuredNanos >= INTERVAL_NANOS)) {
            measuredNanos = now;
            measuring = worker.submit(measurement()::get);
        }
    }

    private ComparisonFigures figures(PictureDifference difference) {
        return new ComparisonFigures(left.medianMillis(), right.medianMillis(), difference);
    }

    private static PictureDifference result(Future<PictureDifference> done) {
        try {
            return done.get();
        } catch (ExecutionException failure) {
            throw new IllegalStateException("pictures cannot be compared", failure.getCause());
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while pictures were compared", interrupted);
        }
    }

    /** Reads both pictures, and returns what measures them on any thread. */
    private Supplier<PictureDifference> measurement() {
        ComparedSide reference = techniques.isReferenceLeft() ? left : right;
        ComparedSide tried = techniques.isReferenceLeft() ? right : left;
        float[] exact = radiance(reference);
        float[] other = radiance(tried);
        int width = small.width();
        Environment environment = reference.renderer().scene().level().environment();
        return () -> PictureDifference.of(exact, other, width, environment);
    }

    private float[] radiance(ComparedSide side) {
        int width = Math.min(MEASURED_WIDTH, side.picture().width());
        int height =
                Math.max(1, width * side.picture().height() / side.picture().width());
        if (small == null || small.width() != width || small.height() != height) {
            closeSmall();
            small = RenderTarget.picture(gl, "measured picture", PixelFormat.RGBA16F, width, height);
        }
        side.renderer().copyRadiance(small);
        return small.readFloats();
    }

    /** Returns the latest figures; the same object until there are others. */
    public ComparisonFigures figures() {
        return figures;
    }

    /** Measures the last frame at once. */
    public ComparisonFigures measureNow() {
        figures = figures(measurement().get());
        return figures;
    }

    /** Drops the history of both sides after a cut. */
    public void forget() {
        left.renderer().forget();
        right.renderer().forget();
    }

    /** Continues the adaption of exposure of what this replaces. */
    public void follow(CloudComparison replaced) {
        left.renderer().follow(replaced.left.renderer());
        right.renderer().follow(replaced.right.renderer());
    }

    private void closeSmall() {
        if (small != null) {
            small.close();
            small = null;
        }
    }

    @Override
    public void close() {
        worker.shutdownNow();
        closeSmall();
        left.close();
        right.close();
    }
}
