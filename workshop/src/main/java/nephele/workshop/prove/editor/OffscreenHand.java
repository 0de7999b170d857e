package nephele.workshop.prove.editor;

import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PaneView;
import nephele.editor.session.EditorSession;
import nephele.engine.math.Vec3;

/** The left hand of a user at points of the world as a pane shows them. */
final class OffscreenHand {
    static final int PERSPECTIVE = 0;
    static final int TOP = 1;

    private final EditorSession session;
    private final Component viewport;
    private final int gap;

    /** @param gap between panes, pixels */
    OffscreenHand(EditorSession session, Component viewport, int gap) {
        this.session = session;
        this.viewport = viewport;
        this.gap = gap;
    }

    /** Moves the pointer to a point without a button. */
    void hover(int pane, Vec3 at) {
        send(MouseEvent.MOUSE_MOVED, MouseEvent.NOBUTTON, point(pane, at));
    }

    /** Presses the left button at a point and holds it at another one. */
    void hold(int pane, Vec3 from, Vec3 to) {
        hover(pane, from);
        send(MouseEvent.MOUSE_PRESSED, MouseEvent.BUTTON1, point(pane, from));
        send(
                MouseEvent.MOUSE_DRAGGED,
                MouseEvent.BUTTON1,
                point(pane, from.plus(to).scaled(0.5)));
        send(MouseEvent.MOUSE_DRAGGED, MouseEvent.BUTTON1, point(pane, to));
    }

    /** Lets the button go at a point. */
    void release(int pane, Vec3 at) {
        send(MouseEvent.MOUSE_RELEASED, MouseEvent.BUTTON1, point(pane, at));
    }

    /** Takes the pointer out of the viewport. */
    void leave() {
        send(MouseEvent.MOUSE_EXITED, MouseEvent.NOBUTTON, new PanePoint(-1, -1, 0));
    }

    private PanePoint point(int pane, Vec3 at) {
        PaneRectangle place = session.panes().rectangles(session.viewport(), gap).stream()
                .filter(each -> each.index() == pane)
                .findFirst()
                .orElseThrow();
        PaneView view = session.panes().views().get(pane);
        PanePoint in = view.camera().project(at, place.size()).orElseThrow();
        return new PanePoint(place.x() + in.x(), place.y() + in.y(), 0);
    }

    private void send(int id, int button, PanePoint at) {
        int held = button == MouseEvent.NOBUTTON ? 0 : InputEvent.getMaskForButton(button);
        viewport.dispatchEvent(new MouseEvent(
                viewport, id, 0, held, (int) Math.round(at.x()), (int) Math.round(at.y()), 1, false, button));
    }
}
