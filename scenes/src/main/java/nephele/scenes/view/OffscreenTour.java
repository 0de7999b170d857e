package nephele.scenes.view;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import nephele.engine.render.Capture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.scenes.fixed.FixedSceneDrawing;

/**
 * Runs `scene` without a display: saves three pictures – at rest, on the way ahead, and banking in a turn. A scene
 * without an entity keeps its camera, and only time passes.
 */
public final class OffscreenTour {
    private static final List<Leg> LEGS = List.of(
            new Leg(0, Set.of(), 0),
            new Leg(1.5, Set.of(ViewerKey.AHEAD), 2),
            new Leg(0.5, Set.of(ViewerKey.AHEAD, ViewerKey.RIGHT), 0));

    private final SceneStart start;
    private final PrintStream out;

    /** Keys held for a time (seconds), after a number of left-turn key presses. */
    private record Leg(double seconds, Set<ViewerKey> held, int turns) {}

    public OffscreenTour(SceneStart start, PrintStream out) {
        this.start = start;
        this.out = out;
    }

    /** @param name the prefix of the pictures' names */
    public void save(Path folder, String name, int width, int height) throws IOException {
        var viewer = start.viewing();
        try (var gl = GlContext.offscreen();
                var target = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, width, height);
                var drawing = FixedSceneDrawing.load(gl, start.opened().sources())) {
            out.println(name + ": drawn offscreen by " + gl.limits().renderer());
            for (int i = 0; i < LEGS.size(); i++) {
                pass(viewer, LEGS.get(i));
                drawing.draw(
                        viewer.view((double) width / height),
                        viewer.sceneSeconds(),
                        viewer.place().worldFromEntity(),
                        viewer.look(),
                        target);
                Path file = folder.resolve(name + "-" + (i + 1) + ".png");
                Capture.png(target, file);
                out.println("picture: " + file);
            }
            gl.requireNoError("scene");
        }
    }

    private void pass(ViewerState viewer, Leg leg) {
        if (start.opened().sources().entity() == null) {
            viewer.advance(leg.seconds, Set.of());
            return;
        }
        for (int i = 0; i < leg.turns; i++) {
            viewer.press(ViewerKey.TURN_LEFT);
        }
        viewer.advance(leg.seconds, leg.held);
    }
}
