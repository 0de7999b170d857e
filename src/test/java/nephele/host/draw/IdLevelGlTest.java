package nephele.host.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;
import org.junit.jupiter.api.Test;

class IdLevelGlTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 90;

    @Test
    void everyPixelIsTheColourOfOneSolidOrBlack() {
        var opened = new LevelName("levels/samples/walking.json").open();
        Set<Integer> allowed = new HashSet<>(Set.of(0));
        for (int i = 0; i < opened.level().solids().size(); i++) {
            assertTrue(allowed.add(IdLevel.colour(i)), "solid " + i + " has a colour of its own");
        }
        var seen = colours(opened);
        assertTrue(allowed.containsAll(seen), seen.toString());
        assertTrue(seen.size() > 5, "several solids are seen");
    }

    @Test
    void theChoiceAsksForValuesAsTheyAre() {
        var level = new LevelName("levels/samples/walking.json").open().level();
        assertEquals(Output.PLAIN, new QualityChoice("high", Map.of("debug", "ids")).output(level));
        assertEquals(level, new QualityChoice("high", Map.of()).drawn(level));
    }

    private static Set<Integer> colours(OpenedLevel opened) {
        Set<Integer> seen = new HashSet<>();
        var level = IdLevel.of(opened.level());
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(gl, "ids", PixelFormat.RGBA8, WIDTH, HEIGHT);
                var renderer = LevelRenderer.load(gl, level, opened.assets(), RenderSettings.of(Output.PLAIN))) {
            var view = Viewpoints.standard(level, opened.file(), (double) WIDTH / HEIGHT)
                    .apply(0);
            renderer.draw(view, picture);
            var bytes = picture.readBytes();
            for (int at = 0; at < bytes.capacity(); at += 4) {
                seen.add((bytes.get(at) & 255) << 16 | (bytes.get(at + 1) & 255) << 8 | bytes.get(at + 2) & 255);
            }
        }
        return seen;
    }
}
