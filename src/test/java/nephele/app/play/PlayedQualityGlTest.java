package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import nephele.app.command.CommandLineFront;
import nephele.app.command.Commands;
import nephele.app.settings.PlayerFiles;
import nephele.engine.render.Capture;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.host.compare.Wipe;
import nephele.host.draw.Preparation;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelName;
import nephele.host.named.Viewpoints;
import nephele.host.terminal.Terminal;
import nephele.host.userfile.UserFolders;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** `render --quality Q` draws what `play` draws at that quality, its share of the pixels included, in every format. */
@Order(1) // one of the longest
class PlayedQualityGlTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 54;

    @TempDir
    Path folder;

    private Path rendered(String level, String quality, String file, String... more) {
        Path out = folder.resolve(file);
        String[] words = {"render", level, "--quality", quality, "--size", WIDTH + "x" + HEIGHT, "--out", out.toString()
        };
        String[] all = Arrays.copyOf(words, words.length + more.length);
        System.arraycopy(more, 0, all, words.length, more.length);
        var err = new ByteArrayOutputStream();
        var terminal = new Terminal(new PrintStream(err), new PrintStream(err, true, StandardCharsets.UTF_8));
        assertEquals(
                0,
                new CommandLineFront(terminal, Commands.ALL).run(all).number(),
                err.toString(StandardCharsets.UTF_8));
        return out;
    }

    /** Draws the level's standard view as the game would, offscreen. */
    private Path played(String level, String quality) throws IOException {
        Path out = folder.resolve("played.png");
        var choice = new QualityChoice(quality, Map.of());
        var name = new LevelName(level);
        var player = new PlayRequest.Player(new PlayerFiles(new UserFolders(null, null, null)), null);
        var request = new PlayRequest(name, null, choice, null, null, null, null, null, player);
        var prepared =
                Preparation.begin(name, choice, share -> {}, warning -> {}).get();
        try (var gl = GlContext.offscreen();
                var target = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, WIDTH, HEIGHT);
                var picture = SessionPicture.load(gl, request, prepared, Optional.empty())) {
            var view = Viewpoints.standard(prepared.opened().level(), level, (double) WIDTH / HEIGHT);
            var state = FrameState.atStart(prepared.scene().level());
            picture.draw(view.apply(0), state, Wipe.MIDDLE, target, StepListener.NONE);
            Capture.png(target, out);
        }
        return out;
    }

    @ParameterizedTest
    @CsvSource({
        "levels/02-first-shot.json, low",
        "levels/02-first-shot.json, auto",
        "levels/samples/portals.json, low",
        "levels/samples/clouds-puffs.json, low"
    })
    void renderDrawsWhatPlayDraws(String level, String quality) throws IOException {
        assertArrayEquals(pixels(played(level, quality)), pixels(rendered(level, quality, "rendered.png")));
    }

    /** The picture of quality low has half the pixels along each side: neighbours are interpolated between them. */
    @Test
    void lowIsJudgedInEveryFormatAtHalfTheResolution() throws IOException {
        String level = "levels/samples/texture-mapping.json";
        assertTrue(detail(rendered(level, "low", "low.pfm")) < 0.75 * detail(rendered(level, "high", "high.pfm")));
        Path full = rendered(level, "low", "full.pfm", "--set", "pictureResolution=1");
        assertTrue(detail(rendered(level, "low", "low.pfm")) < 0.75 * detail(full));
    }

    private static int[] pixels(Path file) throws IOException {
        return ImageIO.read(file.toFile()).getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
    }

    /** Returns the mean second difference along the rows of a PFM's green channel, relative to its mean. */
    private static double detail(Path file) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        int first = bytes.length - 3 * 4 * WIDTH * HEIGHT;
        var floats = ByteBuffer.wrap(bytes, first, bytes.length - first)
                .slice()
                .order(ByteOrder.LITTLE_ENDIAN)
                .asFloatBuffer();
        double sum = 0;
        double mean = 0;
        for (int i = 1; i + 1 < WIDTH * HEIGHT; i++) {
            double here = floats.get(3 * i + 1);
            mean += here;
            sum += Math.abs(floats.get(3 * i - 2) - 2 * here + floats.get(3 * i + 4));
        }
        return sum / mean;
    }
}
