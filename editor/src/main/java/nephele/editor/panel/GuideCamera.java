package nephele.editor.panel;

import nephele.editor.document.EntityBounds;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.session.EditorSession;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Moves the perspective camera into the room that the level is so far. */
final class GuideCamera {
    /** A direction of view. */
    enum Look {
        UP(25),
        AHEAD(-5),
        DOWN(-28);

        private final double pitchDegrees;

        Look(double pitchDegrees) {
            this.pitchDegrees = pitchDegrees;
        }
    }

    private static final double FOV_DEGREES = 75;

    private GuideCamera() {}

    /** Places the camera in the room, near its south wall, looking north. */
    static void inside(EditorSession session, Look look) {
        Aabb room = Aabb.EMPTY;
        for (Solid solid : session.document().level().solids()) {
            room = room.union(EntityBounds.of((Record) solid));
        }
        if (room.isEmpty()) {
            return;
        }
        Vec3 middle = room.centre();
        double south = room.maxZ() - 0.18 * (room.maxZ() - room.minZ());
        var camera = new PerspectiveCamera(
                new Vec3(middle.x(), Math.min(middle.y(), room.minY() + 2.4), south),
                0,
                look.pitchDegrees,
                FOV_DEGREES);
        session.panes(panes -> {
            PaneLayout result = panes;
            for (int i = 0; i < panes.views().size(); i++) {
                PaneView view = panes.views().get(i);
                if (view.kind() == PaneKind.PERSPECTIVE) {
                    result = result.with(i, view.with(camera)).withActive(i);
                }
            }
            return result;
        });
    }
}
