package nephele.workshop.prove.picture;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import nephele.engine.asset.AssetSource;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Billboards;
import nephele.engine.level.Billboards.Facing;
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
import nephele.engine.scene.light.LevelLight;
import nephele.host.named.LevelCatalogue;

/**
 * A level loaded for tracing and for drawing in several ways.
 *
 * @param <V> what differs between the pictures of a view
 */
final class ComparedLevel<V> implements AutoCloseable {
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
    private final Map<V, Renderer> renderers = new LinkedHashMap<>();

    /** @param variants in the order in which they are drawn */
    ComparedLevel(
            GlContext gl, Level level, AssetSource assets, ColourDecoding decoding, Map<V, RenderSettings> variants) {
        this.gl = gl;
        var placed = PlacedLevel.of(level, assets);
        traced = TracedLevel.of(placed, decoding);
        cameras = new SeededCameras(level, traced, 16.0 / 9);
        var scene = Scene.of(placed, LevelLight.unbaked(placed, done -> {}));
        try {
            variants.forEach((variant, settings) -> renderers.put(variant, LevelRenderer.load(gl, scene, settings)));
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

    /** @param drawn called after each variant has been drawn into {@code picture} */
    void draw(View view, RenderTarget picture, BiConsumer<V, Renderer> drawn) {
        renderers.forEach((variant, renderer) -> {
            renderer.draw(view, picture);
            gl.requireNoError(variant.toString());
            drawn.accept(variant, renderer);
        });
    }

    @Override
    public void close() {
        renderers.values().forEach(Renderer::close);
        renderers.clear();
    }

    /**
     * Returns the files of every level and every sample except those with impostors: the tracer traces their meshes, whose
     * edges differ by more than a pixel.
     */
    static List<String> files() {
        List<String> files = new ArrayList<>(in(Path.of("levels")));
        files.addAll(in(Path.of("levels", "samples")));
        return List.copyOf(files);
    }

    /** Returns an empty list outside of a checkout. */
    private static List<String> in(Path folder) {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(LevelCatalogue::isLevel)
                    .filter(ComparedLevel::isWithoutImpostors)
                    .map(Path::toString)
                    .sorted()
                    .toList();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /**
     * Returns a level with those billboards alone that stand still, without wind. The tracer turns others to each ray, the
     * picture to the eye of each view, so that their edges differ by more than a pixel; blended ones are not traced, and
     * neither is the sphere of an observer.
     */
    static Level compared(Level level) {
        return level.withObserver(null)
                .withBillboards(level.billboards().stream()
                        .filter(group -> group.facing() == Facing.CROSSED && !group.blended())
                        .map(Billboards::withoutWind)
                        .toList());
    }

    private static boolean isWithoutImpostors(Path file) {
        try {
            return !Files.readString(file).contains("\"impostor\": true");
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }
}
