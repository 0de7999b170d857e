package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Map;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.portal.Portal;
import nephele.engine.render.Renderer;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.SimSettings;
import nephele.host.draw.Preparation;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelName;
import org.junit.jupiter.api.Test;

/** A rehearsal shows what shots bring about, and leaves the pictures after it as they were. */
class RehearsalGlTest {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 36;
    private static final QualityChoice LOW = new QualityChoice("low", Map.of());

    @Test
    void aWindowOfTwoPortalsStandsBeforeTheEye() {
        var prepared = prepared("levels/04-cube.json");
        Level level = prepared.opened().level();
        Playthrough walk = walk(prepared);
        View view = walk.view(1);
        FrameState all = Rehearsal.of(level, view, walk.frameState()).orElseThrow();
        int first = level.portals().size();
        assertEquals(first + 2, all.portals().size());
        assertEquals(first + 1, all.portals().partner(first));
        Portal window = all.portals().portal(first);
        assertTrue(window.inFront(view.eyeX(), view.eyeY(), view.eyeZ()) > 0.5);
        assertEquals(0, window.across(view.eyeX(), view.eyeY(), view.eyeZ()), 1e-9);
        assertEquals(2, all.shotEffects().size());
        assertEquals(0, all.held(), "a body is held, and drawn transparent");
    }

    @Test
    void aLevelWithoutPortalsHasNone() {
        var prepared = prepared("levels/samples/walking.json");
        Playthrough walk = walk(prepared);
        assertFalse(Rehearsal.of(prepared.opened().level(), walk.view(1), walk.frameState())
                .isPresent());
    }

    @Test
    void thePictureAfterItIsTheSame() {
        var prepared = prepared("levels/samples/portals.json");
        Level level = prepared.opened().level();
        try (var gl = GlContext.offscreen();
                var target = RenderTarget.picture(gl, "rehearsed", PixelFormat.RGBA8, WIDTH, HEIGHT)) {
            var settings = LOW.settings(LOW.output(level), true).with(CharacterPresence.POSSIBLE);
            ByteBuffer alone;
            try (var renderer = LevelRenderer.load(gl, prepared.scene(), settings)) {
                alone = drawn(renderer, walk(prepared), target);
            }
            try (var renderer = LevelRenderer.load(gl, prepared.scene(), settings)) {
                Playthrough walk = walk(prepared);
                View view = walk.view((double) WIDTH / HEIGHT);
                renderer.draw(view, Rehearsal.of(level, view, walk.frameState()).orElseThrow(), target);
                renderer.forget();
                assertEquals(alone, drawn(renderer, walk, target));
            }
        }
    }

    private static ByteBuffer drawn(Renderer renderer, Playthrough walk, RenderTarget target) {
        for (int tick = 0; tick < 4; tick++) {
            walk.tick();
            renderer.draw(walk.view((double) WIDTH / HEIGHT), walk.frameState(), target);
        }
        return target.readBytes();
    }

    private static Preparation.Prepared prepared(String level) {
        return Preparation.begin(new LevelName(level), LOW, share -> {}, warning -> {})
                .get();
    }

    private static Playthrough walk(Preparation.Prepared prepared) {
        var beginning = new Playthrough.Beginning("x.json", SimSettings.DEFAULT, null);
        return new Playthrough(
                prepared.opened().level(),
                prepared.world(),
                beginning,
                new ReplayInput(Replay.standing("x.json", 100)));
    }
}
