package nephele.editor.window.dialog;

import java.util.List;
import nephele.editor.document.Pick;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.session.EditorSession;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** The place in the middle of the active view, where something new is seen at once. */
final class ViewedPlace {
    private static final double MOST_METRES = 20;
    private static final double FREE_METRES = 4;
    private static final double STANDOFF_METRES = 0.5;

    private ViewedPlace() {}

    private static Ray ahead(PerspectiveCamera camera, PaneSize size) {
        return camera.ray(size.width() / 2.0, size.height() / 2.0, size);
    }

    /** Returns the place on the grid as {@code x,y,z}. */
    static String text(EditorSession session) {
        Vec3 at = session.grid().snapped(of(session));
        return at.x() + "," + at.y() + "," + at.z();
    }

    /** Returns a place in front of the nearest surface ahead, or ahead in the air; in a plan, its middle. */
    static Vec3 of(EditorSession session) {
        PaneView view = session.panes().activeView();
        if (view.kind() != PaneKind.PERSPECTIVE) {
            return view.plan().centre();
        }
        PerspectiveCamera camera = view.perspective();
        List<Pick> ahead = session.context().picker().surfaces(ahead(camera, session.viewport()));
        if (ahead.isEmpty() || ahead.get(0).point().minus(camera.eye()).length() > MOST_METRES) {
            return camera.eye().addScaled(FREE_METRES, camera.forward());
        }
        return ahead.get(0).point().addScaled(STANDOFF_METRES, ahead.get(0).normal());
    }
}
