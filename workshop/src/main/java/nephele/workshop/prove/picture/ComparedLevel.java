package nephele.workshop.prove.picture;

import nephele.engine.choice.LevelRenderer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.light.BakedSky;

/**
 * A level loaded for tracing and for drawing in several ways.
 *
 * @param <W> a way to draw
 */
final class ComparedLevel<W> implements AutoCloseable {
    /** The largest value of {@code --set viewBudget}. */
    static final int UNLIMITED = 9999;

    /**
     * The compared techniques. The others of {@link PortalTechnique} are variants of the second; the trade report
     * compares them.
     */
    static final List<PortalTechnique> TECHNIQUES = List.of(PortalTechnique.STENCIL, PortalTechnique.TEXTURE);

    private final GlContext gl;
    private final TracedLevel traced;
    private final SeededCameras cameras;
    private final Map<W, Renderer> renderers = new LinkedHashMap<>();

    /** @param ways in the order in which they are drawn */
    ComparedLevel(GlContext gl, Level level, AssetSource assets, ColourDecoding decoding, Map<W, RenderSettings> ways) {
        this.gl = gl;
        var placed = PlacedLevel.of(level, assets);
        traced = TracedLevel.of(placed, decoding);
        cameras = new SeededCameras(level, traced, 16.0 / 9);
        var scene = Scene.of(placed, BakedSky.of(placed, done -> {}));
        try {
            ways.forEach((way, settings) -> renderers.put(way, LevelRenderer.load(gl, scene, settings)));
        } catch (RuntimeException failure) {
            close();
            throw failure;
        }
    }

    TracedLevel traced() {
        return traced;
    }

    View view(int camera) {
        return cameras.view(camera);
    }

    /** @param drawn called after each way has been drawn into {@code picture} */
    void draw(View view, RenderTarget picture, BiConsumer<W, Renderer> drawn) {
        renderers.forEach((way, renderer) -> {
            renderer.draw(view, picture);
            gl.requireNoError(way.toString());
            drawn.accept(way, renderer);
        });
    }

    @Override
    public void close() {
        renderers.values().forEach(Renderer::close);
        renderers.clear();
    }
}
