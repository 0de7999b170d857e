package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** `render --reference` and `render` show the same surfaces, light and tone mapping. */
class ReferenceGlTest {
    private static final int WIDTH = 128;
    private static final int HEIGHT = 72;

    @TempDir
    Path folder;

    private Path rendered(String level, String ending, String... options) {
        var file = folder.resolve(options.length + ending);
        var words = new ArrayList<>(List.of("render", level, "--out", file.toString(), "--size", WIDTH + "x" + HEIGHT));
        words.addAll(List.of(options));
        var answer = Captured.run(words.toArray(String[]::new));
        assertEquals(0, answer.exitCode(), answer.err());
        return file;
    }

    /** No pixel shows another solid than that of the reference path tracer, except within one pixel of an edge. */
    @ParameterizedTest
    @ValueSource(strings = {"01-courtyard", "samples/solid-wedge", "samples/sky-visibility", "samples/portalable"})
    void everyPixelShowsTheSolidThatTheOracleSees(String name) throws IOException {
        var level = "levels/" + name + ".json";
        var drawn = ImageIO.read(rendered(level, ".png", "--set", "debug=ids").toFile());
        var traced = ImageIO.read(
                rendered(level, ".png", "--reference", "--set", "debug=ids").toFile());
        int elsewhere = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                elsewhere += isNear(traced, x, y, drawn.getRGB(x, y)) ? 0 : 1;
            }
        }
        assertEquals(0, elsewhere, "pixels that show another solid");
    }

    private static boolean isNear(BufferedImage picture, int column, int row, int rgb) {
        for (int y = Math.max(row - 1, 0); y <= Math.min(row + 1, HEIGHT - 1); y++) {
            for (int x = Math.max(column - 1, 0); x <= Math.min(column + 1, WIDTH - 1); x++) {
                if (picture.getRGB(x, y) == rgb) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Exposure, tone curve, sRGB and dither agree: a sky without surfaces has the same codes except for rounding. */
    @Test
    void toneMappingIsTheEngines() throws IOException {
        var level = "levels/samples/tone-filmic.json";
        String[] up = {"--eye", "0,3,0", "--target", "0,9,-3", "--output", "direct"};
        var drawn = ImageIO.read(rendered(level, ".png", up[0], up[1], up[2], up[3], up[4], up[5], "--quality", "ultra")
                .toFile());
        var traced = ImageIO.read(
                rendered(level, ".png", up[0], up[1], up[2], up[3], up[4], up[5], "--reference", "--spp", "1")
                        .toFile());
        int off = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            int a = drawn.getRGB(i % WIDTH, i / WIDTH);
            int b = traced.getRGB(i % WIDTH, i / WIDTH);
            off += a == b ? 0 : 1;
            assertTrue(Math.abs((a & 255) - (b & 255)) <= 1, "pixel " + i);
        }
        assertTrue(off < WIDTH * HEIGHT / 50, off + " pixels differ by a code");
    }

    @Test
    void progressIsShownAndTheSeedCounts() throws IOException {
        var level = "levels/samples/sky-visibility.json";
        var file = folder.resolve("shown.png").toString();
        var answer = Captured.run(
                "render", level, "--out", file, "--size", "16x9", "--reference", "--spp", "2", "--seed", "9");
        assertEquals(0, answer.exitCode(), answer.err());
        assertTrue(answer.err().contains("tracing the reference: 100 %"), answer.err());
        byte[] first = Files.readAllBytes(Path.of(file));
        Captured.run("render", level, "--out", file, "--size", "16x9", "--reference", "--spp", "2", "--seed", "9");
        assertArrayEquals(first, Files.readAllBytes(Path.of(file)));
        Captured.run("render", level, "--out", file, "--size", "16x9", "--reference", "--spp", "2", "--seed", "8");
        assertTrue(!Arrays.equals(first, Files.readAllBytes(Path.of(file))));
    }
}
