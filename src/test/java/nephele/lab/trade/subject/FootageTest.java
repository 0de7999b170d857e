package nephele.lab.trade.subject;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.function.Function;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
import nephele.host.named.LevelName;
import nephele.lab.trade.TradeSite;
import nephele.lab.trade.TradeView;
import org.junit.jupiter.api.Test;

class FootageTest {
    private static Footage path(int width, int height) {
        return footage(width, height, Footage::path);
    }

    private static Footage footage(int width, int height, Function<TradeSite, Footage> of) {
        var opened = new LevelName("levels/samples/cameras.json").open();
        var extent = new TradeSite.Extent(width, height, 1);
        var seen = TradeView.of(opened, null, extent.aspect());
        try (var site =
                new TradeSite(opened, seen, extent, Path.of("."), new PrintStream(OutputStream.nullOutputStream()))) {
            return of.apply(site);
        }
    }

    @Test
    void picturesOfAPathHaveTheSameShapeAndAreSmall() {
        assertEquals(320, path(1280, 720).width());
        assertEquals(180, path(1280, 720).height());
        assertEquals(180, path(360, 360).width());
        assertEquals(64, path(64, 36).width());
        assertEquals(36, path(64, 36).height());
    }

    /** The point in the middle of each frame lies 0.3 pixels aside in the frame before, 0.24 of them to the right. */
    @Test
    void aPathTurnsByThreeTenthsOfAPixel() {
        Footage path = path(320, 180);
        assertEquals(Footage.PATH_FRAMES, path.views().size());
        for (int frame = 1; frame < Footage.PATH_FRAMES; frame++) {
            View before = path.views().get(frame - 1);
            Vec3 ahead = path.views().get(frame).back().negated();
            double perPixel = 2 * before.projection().tanHalfHeight() / 180;
            double depth = -ahead.dot(before.back());
            assertEquals(0.24, ahead.dot(before.right()) / depth / perPixel, 1e-3);
            assertEquals(0.18, ahead.dot(before.up()) / depth / perPixel, 1e-3);
            assertEquals(path.views().get(0).eye(), path.views().get(frame).eye());
        }
    }

    @Test
    void aRunMovesTheEyeByATenthOfAMetreAndTurnsNothing() {
        Footage run = footage(320, 180, Footage::run);
        assertEquals(Footage.PATH_FRAMES, run.views().size());
        View first = run.views().get(0);
        for (int frame = 0; frame < Footage.PATH_FRAMES; frame++) {
            View view = run.views().get(frame);
            assertEquals(0.1 * frame, view.eye().minus(first.eye()).dot(first.right()), 1e-9);
            assertEquals(0.1 * frame, view.eye().minus(first.eye()).length(), 1e-9);
            assertEquals(first.back(), view.back());
        }
    }
}
