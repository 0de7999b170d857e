package nephele.lab.trade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import nephele.host.named.LevelName;
import nephele.lab.trade.subject.Trades;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pictures drawn by another renderer do not count; a run that only reads reports the renderer that drew them. */
class SubjectFileGlTest {
    private static final SubjectState STATE =
            SubjectState.NOTHING.with(new SubjectState.Judged(0.5, List.of(1.0), false));

    @TempDir
    Path folder;

    private TradeSite site() {
        var opened = new LevelName("levels/samples/empty.json").open();
        var extent = new TradeSite.Extent(16, 9, 1);
        return new TradeSite(
                opened,
                TradeView.of(opened, null, extent.aspect()),
                extent,
                folder,
                new PrintStream(OutputStream.nullOutputStream()));
    }

    private SubjectFile file(TradeSite site) {
        Trade trade = Trades.ALL.get(0);
        return new SubjectFile(folder, trade, "key", site);
    }

    @Test
    void isOfTheRendererThatDrew() throws IOException {
        String graphics;
        try (var drawing = site()) {
            graphics = drawing.gl().limits().renderer();
            file(drawing).save(STATE);
        }
        try (var reading = site()) {
            assertEquals(STATE, file(reading).load());
            assertEquals(graphics, reading.graphics());
        }
        Path kept = folder.resolve(Trades.ALL.get(0).subject() + ".properties");
        String text = Files.readString(kept);
        Files.writeString(kept, text.replaceAll("(?m)^graphics=.*$", "graphics=another"));
        try (var elsewhere = site()) {
            assertTrue(file(elsewhere).isOfAnotherRun());
        }
        Files.writeString(kept, text.replaceAll("(?m)^graphics=.*$", "graphics="));
        try (var undrawn = site()) {
            assertFalse(file(undrawn).isOfAnotherRun());
            assertEquals("", undrawn.graphics(), "without pictures no context is made");
        }
    }
}
