package nephele.lab.trade;

import java.util.Comparator;
import java.util.List;
import nephele.engine.level.Camera;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewTree;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;

/**
 * The view in which a level is judged.
 *
 * @param camera its description in words
 */
public record TradeView(View view, String camera) {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 360;

    /**
     * Returns the view of a camera.
     *
     * @param camera id of one of the level's cameras; {@code null} for the first of those that see the most portal
     *     pixels
     */
    public static TradeView of(OpenedLevel opened, String camera, double aspect) {
        var level = opened.level();
        if (camera != null) {
            return new TradeView(
                    Viewpoints.named(level, opened.file(), camera, aspect).apply(0), "camera " + camera);
        }
        List<Camera> cameras = level.cameras();
        if (cameras.isEmpty()) {
            return new TradeView(
                    Viewpoints.standard(level, opened.file(), aspect).apply(0), "player's start");
        }
        var frameState = FrameState.atStart(level);
        return cameras.stream()
                .map(each -> new TradeView(View.ofCamera(each, 0, aspect), "camera " + each.id()))
                .max(Comparator.comparingDouble(each -> each.portalPixels(frameState)))
                .filter(most -> most.portalPixels(frameState) > 0)
                .orElseGet(() -> new TradeView(
                        View.ofCamera(cameras.get(0), 0, aspect),
                        "camera " + cameras.get(0).id()));
    }

    /** Returns the pixels that portals cover in a picture of 640 × 360. */
    private double portalPixels(FrameState frameState) {
        var tree = new ViewTree(List.of());
        tree.build(view, frameState, WIDTH, HEIGHT, 0);
        return tree.terminals().stream().mapToDouble(opening -> opening.area()).sum();
    }
}
