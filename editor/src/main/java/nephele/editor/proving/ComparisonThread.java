package nephele.editor.proving;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.render.Capture;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.host.compare.CloudComparison;
import nephele.host.compare.CloudComparison.ComparedScenes;
import nephele.host.compare.ComparisonFigures;

/** Draws comparisons on a thread with an OpenGL context of its own, which begins with the first one. */
public final class ComparisonThread implements AutoCloseable {
    public static final int WIDTH = 320;
    public static final int HEIGHT = 180;

    private final ExecutorService thread = Executors.newSingleThreadExecutor(task -> {
        Thread made = new Thread(task, "compared techniques");
        made.setDaemon(true);
        made.setPriority(Thread.MIN_PRIORITY);
        return made;
    });
    // Used by that thread alone.
    private GlContext gl;
    private CloudComparison comparison;
    private ComparedScenes scenes;
    private PlacedLevel placed;
    private BakedLight light;
    private ComparedCloud drawn;
    private FrameState state;

    /**
     * Draws frames and waits for them.
     *
     * @param frames of which the times are taken; the first one of another question is complete without earlier ones
     */
    public ComparedPictures draw(ComparedCloud asked, int frames) {
        try {
            return thread.submit(() -> drawNow(asked, frames)).get();
        } catch (ExecutionException failure) {
            return ComparedPictures.failed(asked.techniques(), reason(failure.getCause()));
        } catch (RejectedExecutionException closed) {
            return ComparedPictures.failed(asked.techniques(), "");
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return ComparedPictures.failed(asked.techniques(), "");
        }
    }

    private static String reason(Throwable cause) {
        return String.valueOf(cause.getMessage()).lines().findFirst().orElse("");
    }

    private ComparedPictures drawNow(ComparedCloud asked, int frames) {
        if (gl == null) {
            gl = GlContext.offscreen();
        }
        if (!asked.isOfSameScenes(drawn)) {
            follow(asked);
        }
        if (!asked.isSame(drawn)) {
            comparison.forget();
        }
        drawn = asked;
        for (int frame = 0; frame < frames; frame++) {
            comparison.draw(asked.view((double) WIDTH / HEIGHT), state, WIDTH, HEIGHT, StepListener.NONE);
        }
        ComparisonFigures figures = comparison.measureNow();
        gl.requireNoError("comparison");
        return new ComparedPictures(
                asked.techniques(),
                Capture.image(comparison.leftPicture()),
                Capture.image(comparison.rightPicture()),
                figures,
                null);
    }

    /** Follows an edit; what it leaves as it was stays on the GPU. */
    private void follow(ComparedCloud asked) {
        drawn = null;
        boolean isEdited = placed != null && placed.assets() == asked.assets();
        place(asked, isEdited);
        ComparedScenes next = new ComparedScenes(
                asked.techniques(),
                scene(asked, asked.techniques().left(), isEdited ? scenes.left() : null),
                scene(asked, asked.techniques().right(), isEdited ? scenes.right() : null));
        if (comparison != null && comparison.techniques().equals(asked.techniques())) {
            comparison.edit(next);
        } else {
            CloudComparison other = CloudComparison.load(gl, next, RenderSettings.of(Output.HDR));
            closeComparison();
            comparison = other;
        }
        scenes = next;
        state = FrameState.atStart(placed.level());
    }

    private void place(ComparedCloud asked, boolean isEdited) {
        PlacedLevel before = placed;
        placed = isEdited ? placed.edited(asked.level()) : PlacedLevel.of(asked.level(), asked.assets());
        if (!LightRequirements.skyVisibility(placed.level())) {
            light = null;
        } else if (light == null || before == null || before.statics() != placed.statics()) {
            light = LevelLight.known(placed).orElseGet(BakedLight::open);
        }
    }

    /** @param before {@code null} for none of the same files */
    private Scene scene(ComparedCloud asked, CloudTechnique technique, Scene before) {
        Level level = asked.drawnBy(technique, placed.level());
        PlacedLevel next = new PlacedLevel(level, placed.assets(), placed.statics());
        return before == null ? Scene.of(next, light) : before.edited(next, light);
    }

    private void closeComparison() {
        if (comparison != null) {
            comparison.close();
            comparison = null;
        }
    }

    /** Ends the context after what is being drawn. */
    @Override
    public void close() {
        thread.execute(() -> {
            closeComparison();
            if (gl != null) {
                gl.close();
            }
        });
        thread.shutdown();
    }
}
