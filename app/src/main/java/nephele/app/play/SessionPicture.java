package nephele.app.play;

import java.util.Optional;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.host.compare.CloudComparison;
import nephele.host.compare.CloudComparison.ComparedScenes;
import nephele.host.compare.TechniquePair;
import nephele.host.compare.Wipe;
import nephele.host.draw.Preparation;
import nephele.host.terminal.CommandFailure;

/** Draws a level that is played: by one renderer, or by two techniques of its clouds that are compared. */
final class SessionPicture implements AutoCloseable {
    /** {@code null} for a comparison. */
    private Renderer renderer;
    /** {@code null} without one. */
    private final CloudComparison comparison;

    private SessionPicture(Renderer renderer, CloudComparison comparison) {
        this.renderer = renderer;
        this.comparison = comparison;
    }

    /**
     * Builds what draws a prepared level.
     *
     * @param automatic the quality in place of the preset
     */
    static SessionPicture load(
            GlContext gl, PlayRequest request, Preparation.Prepared prepared, Optional<Quality> automatic) {
        var choice = request.chosenQuality();
        var output = choice.output(prepared.opened().level());
        RenderSettings settings = automatic
                .map(quality -> choice.settings(output, quality))
                .orElseGet(() -> choice.settings(output, gl.limits().software()))
                .with(CharacterPresence.POSSIBLE);
        if (request.compared() == null) {
            return new SessionPicture(
                    prepared.opened().reporting(() -> LevelRenderer.load(gl, prepared.scene(), settings)), null);
        }
        requireClouds(request, prepared.scene());
        ComparedScenes scenes = ComparedScenes.ofAllClouds(prepared.scene(), request.compared());
        return new SessionPicture(null, prepared.opened().reporting(() -> CloudComparison.load(gl, scenes, settings)));
    }

    private static void requireClouds(PlayRequest request, Scene scene) {
        TechniquePair.obstacle(scene.level()).ifPresent(obstacle -> {
            throw CommandFailure.usage("--compare: " + request.level().typed() + ": " + obstacle);
        });
    }

    /** Draws over the whole picture; {@code wipe} divides it if techniques are compared. */
    void draw(View view, FrameState state, Wipe wipe, RenderTarget picture, StepListener listener) {
        if (comparison == null) {
            renderer.draw(view, state, picture, listener);
        } else {
            comparison.draw(view, state, picture.width(), picture.height(), listener);
            comparison.compose(wipe, picture);
        }
    }

    /** Returns the renderer; of a comparison the left one. */
    Renderer renderer() {
        return comparison == null ? renderer : comparison.leftRenderer();
    }

    /** Returns the comparison; {@code null} without one. */
    CloudComparison comparison() {
        return comparison;
    }

    /** Drops the history of pictures after a cut. */
    void forget() {
        if (comparison == null) {
            renderer.forget();
        } else {
            comparison.forget();
        }
    }

    /** Continues the adaption of exposure of what this replaces. */
    void follow(SessionPicture replaced) {
        if (comparison == null) {
            renderer.follow(replaced.renderer);
        } else {
            comparison.follow(replaced.comparison);
        }
    }

    /** Follows other light of the same level. */
    void edit(Scene scene) {
        if (comparison == null) {
            renderer = LevelRenderer.edited(renderer, scene);
        } else {
            comparison.edit(ComparedScenes.ofAllClouds(scene, comparison.techniques()));
        }
    }

    @Override
    public void close() {
        if (comparison == null) {
            renderer.close();
        } else {
            comparison.close();
        }
    }
}
