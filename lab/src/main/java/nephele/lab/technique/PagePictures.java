package nephele.lab.technique;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Hash64;
import nephele.engine.render.Capture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LevelLight;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.lab.trade.Pictures;
import nephele.lab.trade.Provenance;

/** Draws the pictures of pages, as {@code render} does, and keeps them in a folder until the code changes. */
final class PagePictures implements AutoCloseable {
    /** Frames after which what reuses earlier ones has settled. */
    private static final int FRAMES = 4;

    private final Path folder;
    private final int width;
    private final int height;
    private final PrintStream log;
    private GlContext gl;

    PagePictures(Path folder, int width, int height, PrintStream log) {
        this.folder = folder;
        this.width = width;
        this.height = height;
        this.log = log;
    }

    /** Returns a picture as the address of an image element; empty if its level does not exist. */
    Optional<String> address(PictureCommand command) {
        try {
            return drawn(command);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    private Optional<String> drawn(PictureCommand command) throws IOException {
        String key = command.words() + " " + width + "x" + height + " " + Provenance.codeHash();
        Path file = folder.resolve("page-" + Long.toHexString(Hash64.of(key)) + ".png");
        if (!Files.exists(file)) {
            OpenedLevel opened;
            try {
                opened = new LevelName(command.level()).open();
            } catch (LevelFormatException missing) {
                log.println("page without a picture: " + missing.getMessage());
                return Optional.empty();
            }
            log.println("picture: " + command.words());
            draw(command, opened, file);
        }
        return Optional.of(Pictures.dataAddress(file));
    }

    private void draw(PictureCommand command, OpenedLevel opened, Path file) throws IOException {
        if (gl == null) {
            gl = GlContext.offscreen();
        }
        Level level = command.drawn(opened.level());
        PlacedLevel placed = PlacedLevel.of(level, opened.assets());
        var settings = command.quality()
                .settings(QualityChoice.defaultOutput(level), gl.limits().software());
        try (var target = RenderTarget.picture(gl, "page", PixelFormat.RGBA8, width, height);
                var renderer = LevelRenderer.load(gl, Scene.of(placed, LevelLight.of(placed, done -> {})), settings)) {
            FrameState state = FrameState.atStart(level);
            state.seconds(command.seconds());
            for (int frame = 0; frame < FRAMES; frame++) {
                renderer.draw(command.view(opened, (double) width / height), state, target);
            }
            gl.requireNoError("page");
            Capture.png(target, file);
        }
    }

    @Override
    public void close() {
        if (gl != null) {
            gl.close();
        }
    }
}
