package nephele.editor.pane;

import java.util.Optional;
import nephele.engine.level.Camera;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;

/** The views of a level that has just been opened: from its first camera, else from where its player starts. */
public final class OpeningViews {
    private static final double EYE_METRES = 1.65;

    /** A place to look from, and its surroundings for plans. */
    private record Sight(Vec3 eye, double yawDegrees, double pitchDegrees, Vec3 middle) {}

    private OpeningViews() {}

    /** Returns the panes with these views; the panes as they are for a level without camera and start. */
    public static PaneLayout of(Level level, PaneLayout panes) {
        return sight(level)
                .map(sight -> panes.each(view -> new PaneView(
                        view.kind(),
                        new PerspectiveCamera(
                                sight.eye,
                                sight.yawDegrees,
                                sight.pitchDegrees,
                                view.perspective().verticalFovDegrees()),
                        PlanCamera.at(view.plan(), sight.middle),
                        view.mode())))
                .orElse(panes);
    }

    private static Optional<Sight> sight(Level level) {
        if (!level.cameras().isEmpty()) {
            return Optional.of(from(level.cameras().get(0)));
        }
        return Optional.ofNullable(level.player()).map(OpeningViews::from);
    }

    private static Sight from(Camera camera) {
        Vec3 along = camera.target().minus(camera.position());
        double flat = Math.hypot(along.x(), along.z());
        return new Sight(
                camera.position(),
                Math.toDegrees(Math.atan2(-along.x(), -along.z())),
                Math.toDegrees(Math.atan2(along.y(), flat)),
                camera.target());
    }

    private static Sight from(PlayerStart start) {
        Vec3 eye = start.feet().plus(new Vec3(0, EYE_METRES, 0));
        return new Sight(eye, start.yawDegrees(), start.pitchDegrees(), start.feet());
    }
}
