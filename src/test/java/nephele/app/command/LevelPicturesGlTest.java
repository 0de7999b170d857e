package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.host.named.LevelCatalogue;
import nephele.host.named.LevelName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The level list's pictures show the levels as they are. After a change of a level: {@code ./nephele render
 * levels/01-courtyard.json --quality ultra --size 384x216 --out levels/pictures/01-courtyard.png}.
 */
class LevelPicturesGlTest {
    @TempDir
    Path folder;

    @Test
    void everyLevelOfTheCampaignHasOne() {
        for (LevelName level : LevelCatalogue.campaign()) {
            Picture picture = level.picture().orElseThrow();
            assertEquals(384, picture.width(), level.fileName());
            assertEquals(216, picture.height(), level.fileName());
        }
        assertEquals(Optional.empty(), new LevelName("levels/samples/walking.json").picture());
    }

    @Test
    void theFirstOneIsDrawnByTheEngine() throws Exception {
        LevelName level = LevelCatalogue.first();
        Path drawn = folder.resolve("drawn.png");
        var size = "384x216";
        Captured.run("render", level.typed(), "--quality", "ultra", "--size", size, "--out", drawn.toString());
        Picture now = PictureDecoder.decode("drawn.png", Files.readAllBytes(drawn));
        Picture kept = level.picture().orElseThrow();
        long sum = 0;
        for (int i = 0; i < 384 * 216; i++) {
            for (int channel = 0; channel < 3; channel++) {
                sum += Math.abs(now.sample(i % 384, i / 384, channel) - kept.sample(i % 384, i / 384, channel));
            }
        }
        double mean = sum / (3.0 * 384 * 216);
        assertTrue(mean < 2, "the picture differs by " + mean + " codes on average: render it anew");
    }
}
