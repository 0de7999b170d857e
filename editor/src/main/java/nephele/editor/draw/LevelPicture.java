package nephele.editor.draw;

import nephele.editor.pane.ViewMode;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.bake.BakedLight;

/** The level in one view mode on the GPU, followed through edits. */
final class LevelPicture implements AutoCloseable {
    private final GlContext gl;
    private final ViewMode mode;
    private final ViewModeLevel derivation;
    private PlacedLevel placed;
    private BakedLight baked;
    private Renderer renderer;
    private Output output;
    private FrameState state;
    private boolean isGradual;

    LevelPicture(GlContext gl, ViewMode mode, Vec3 background) {
        this.gl = gl;
        this.mode = mode;
        derivation = new ViewModeLevel(mode, background);
    }

    /**
     * Lets time pass in which earlier edits are taken over gradually.
     *
     * @param seconds since the last picture; {@link Double#POSITIVE_INFINITY} for pictures that are complete at once
     */
    void elapse(double seconds) {
        isGradual = seconds < Double.POSITIVE_INFINITY;
        if (renderer != null) {
            renderer.elapse(seconds);
        }
    }

    /** Returns how far the last edit is taken over, 1 for wholly. */
    double changed() {
        return renderer == null ? 1 : renderer.changed();
    }

    /**
     * Follows an edit; unchanged parts stay on the GPU.
     *
     * @param base the visible level; others of the same document share its shapes
     * @param light {@code null} if none is baked yet
     */
    void show(PlacedLevel base, BakedLight light) {
        Level level = derivation.of(base.level());
        boolean isSame = placed != null && placed.level() == level && baked == light;
        if (isSame) {
            return;
        }
        PlacedLevel next = placed(base, level);
        Scene scene = renderer == null
                ? Scene.of(next, first(level, light))
                : renderer.scene().edited(next, light);
        load(scene, outputOf(level));
        state = FrameState.atStart(level);
        placed = next;
        baked = light;
    }

    /** Returns the output that is enough for the editor: linear light only for clouds, and to meter exposure. */
    private static Output outputOf(Level level) {
        Environment environment = level.environment();
        boolean isLinear = environment.exposureStops().isAuto()
                || !WeatherClouds.all(environment).isEmpty();
        return isLinear ? Output.HDR : Output.DIRECT;
    }

    private void load(Scene scene, Output wanted) {
        if (renderer != null && output == wanted) {
            renderer =
                    isGradual ? LevelRenderer.editedGradually(renderer, scene) : LevelRenderer.edited(renderer, scene);
            return;
        }
        Renderer next = LevelRenderer.load(gl, scene, RenderSettings.of(wanted));
        close();
        renderer = next;
        output = wanted;
    }

    private static BakedLight first(Level level, BakedLight light) {
        if (LightRequirements.skyVisibility(level)) {
            return light == null ? BakedLight.open() : light;
        }
        return light == null || light.indirect() == null ? null : light;
    }

    private PlacedLevel placed(PlacedLevel base, Level level) {
        boolean isBase = level.solids() == base.level().solids()
                && level.models() == base.level().models();
        if (isBase) {
            return new PlacedLevel(level, base.assets(), base.statics());
        }
        return placed == null ? PlacedLevel.of(level, base.assets()) : placed.edited(level);
    }

    /** Draws over the whole target, colours and depth. */
    void draw(View view, RenderTarget picture) {
        if (mode != ViewMode.LIT) {
            state.environment(
                    ViewModeLevel.evenLight(placed.level().environment(), view.right(), view.up(), view.back()));
        }
        if (output == Output.HDR) {
            // No time passes in which exposure could adapt: each view is shown as its picture calls for.
            renderer.forget();
        }
        renderer.draw(view, state, picture);
        renderer.copyDepth(picture);
    }

    @Override
    public void close() {
        if (renderer != null) {
            renderer.close();
            renderer = null;
        }
    }
}
