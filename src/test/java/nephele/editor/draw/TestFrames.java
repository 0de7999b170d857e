package nephele.editor.draw;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.editor.draw.ViewportFrame.Look;
import nephele.editor.draw.ViewportFrame.Pane;
import nephele.editor.pane.Mark;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.ViewMode;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;

/** Small levels and frames of one pane for tests of the drawing. */
final class TestFrames {
    static final int WIDTH = 200;
    static final int HEIGHT = 150;
    static final PaneCamera AHEAD = new PerspectiveCamera(new Vec3(0, 1, 5), 0, 0, 60);

    private TestFrames() {}

    /** No files, and derived ones in a folder of the test. */
    record NoFiles(Path cache) implements AssetSource {
        @Override
        public byte[] bytes(String assetId) {
            throw new AssetException(assetId, "there is no such file", "put it there");
        }

        @Override
        public boolean exists(String assetId) {
            return false;
        }

        @Override
        public Optional<Path> cacheFolder() {
            return Optional.ofNullable(cache);
        }
    }

    static Solid.Box box(String id, Vec3 centre, Vec3 size, boolean portalable) {
        return new Solid.Box(id, null, portalable, TextureMapping.WORLD, centre, size, Map.of());
    }

    static Level level(Solid... solids) {
        Environment environment = new Environment(
                null,
                new Sky.Constant(new Vec3(0.1, 0.1, 0.3)),
                null,
                Exposure.NEUTRAL,
                ToneCurve.CLIP,
                null,
                List.of());
        return Level.of("test", "", environment, List.of()).with(List.<Material>of(), List.of(solids));
    }

    static ViewportFrame frame(Level level, AssetSource assets, PaneCamera camera, ViewMode mode, List<Mark> marks) {
        PaneView view = PaneView.of(PaneKind.PERSPECTIVE, mode).with(camera);
        Pane pane = new Pane(new PaneRectangle(0, 0, 0, WIDTH, HEIGHT), view, "", List.of());
        Look look = new Look(Background.DARK, 0.125, false, 1);
        return new ViewportFrame(level, assets, List.of(pane), 0, marks, look, true, false);
    }
}
