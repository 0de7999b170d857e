package nephele.lab.trade;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Optional;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.measure.LinearPicture;
import nephele.engine.reference.LightTransport;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedExposure;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.terminal.PrintedProgress;
import nephele.lab.bake.TracedPictures;

/**
 * The environment in which subjects are measured: a level, a view of it and one OpenGL context. Reference pictures
 * are kept between runs.
 */
public final class TradeSite implements AutoCloseable {
    private final OpenedLevel opened;
    private final TradeView viewpoint;
    private final Extent extent;
    private final Path folder;
    private final PrintStream log;
    private GlContext gl;
    /** The level's light; {@code null} before it is asked for. */
    private Optional<BakedLight> light;

    /**
     * The size of pictures and the quality of the reference picture's.
     *
     * @param samples rays a pixel
     */
    public record Extent(int width, int height, int samples) {
        public double aspect() {
            return (double) width / height;
        }
    }

    /** @param folder for files that are kept between runs */
    public TradeSite(OpenedLevel opened, TradeView viewpoint, Extent extent, Path folder, PrintStream log) {
        this.opened = opened;
        this.viewpoint = viewpoint;
        this.extent = extent;
        this.folder = folder;
        this.log = log;
    }

    public Level level() {
        return opened.level();
    }

    public PlacedLevel placed() {
        return opened.placed();
    }

    public View view() {
        return viewpoint.view();
    }

    /** Returns a site with the same context and another level, seen by the camera with the most portal pixels. */
    public TradeSite in(String level) {
        var other = new LevelName(level).open();
        return sharing(other, TradeView.of(other, null, extent.aspect()));
    }

    /**
     * Returns a site with the same context, level and view.
     *
     * @param assets all of the level's, unchanged, and others
     */
    public TradeSite with(AssetSource assets) {
        var read = new LevelFile.Opened(opened.file(), opened.level(), assets, opened.notice());
        return sharing(new OpenedLevel(read), viewpoint);
    }

    private TradeSite sharing(OpenedLevel other, TradeView view) {
        var site = new TradeSite(other, view, extent, folder, log);
        site.gl = gl();
        return site;
    }

    public Extent extent() {
        return extent;
    }

    /** Returns the OpenGL context. It is created at the first call, because subjects without pictures need none. */
    public GlContext gl() {
        if (gl == null) {
            gl = GlContext.offscreen();
        }
        return gl;
    }

    /** Returns the OpenGL renderer's name; empty if no context was created. */
    public String graphics() {
        return gl == null ? "" : gl.limits().renderer();
    }

    /** Returns true if pictures drawn by the renderer {@code graphics} can be compared with those drawn here. */
    public boolean drawsLike(String graphics) {
        return graphics.isEmpty() || graphics.equals(gl().limits().renderer());
    }

    public Scene scene(Level level) {
        return opened.reporting(() -> {
            var placed = opened.placed().edited(level);
            boolean hasItsLight =
                    isBaked() && placed.statics() == opened.placed().statics();
            return Scene.of(placed, hasItsLight ? light.get() : LevelLight.of(placed, PrintedProgress.ofBake(log)));
        });
    }

    /** Returns true if the level's own light was baked: then every variant of it is drawn with that. */
    private boolean isBaked() {
        if (light == null) {
            light = Optional.ofNullable(LevelLight.of(opened.placed(), PrintedProgress.ofBake(log)));
        }
        return light.isPresent() && light.get().indirect() != null;
    }

    /**
     * Returns the exact twin's radiance of this view, bottom row first; traced at the first call and then read from the
     * folder. The twin follows light over surfaces if the level's light was baked.
     */
    public LinearPicture reference() {
        return reference(isBaked() ? LightTransport.BAKED : LightTransport.DIRECT);
    }

    /** Returns that picture with light that is followed so far. */
    public LinearPicture reference(LightTransport light) {
        int threads = Runtime.getRuntime().availableProcessors();
        var settings = new TraceSettings(extent.width, extent.height, extent.samples, 1, threads, light);
        var eye = TracedPictures.pinhole(viewpoint.view());
        return new TracedPictures(folder, Provenance.codeHash())
                .picture(TracedPictures.levelHash(opened), eye, settings, () -> trace(eye, settings));
    }

    private float[] trace(Pinhole eye, TraceSettings settings) {
        var level = opened.reporting(() -> TracedLevel.of(
                TracedExposure.fixed(opened.placed(), ColourDecoding.SRGB, eye, 0), ColourDecoding.SRGB));
        return ReferencePicture.trace(level, eye, settings, PrintedProgress.ofTrace(log));
    }

    @Override
    public void close() {
        if (gl != null) {
            gl.close();
        }
    }
}
