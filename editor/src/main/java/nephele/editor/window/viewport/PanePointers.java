package nephele.editor.window.viewport;

import java.awt.event.MouseEvent;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import nephele.editor.document.Picker;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PaneLayout.Splitter;
import nephele.editor.pane.PaneView;
import nephele.editor.session.EditorSession;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Button;
import nephele.editor.tool.Pointer.Modifier;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** Maps events of the mouse, in points of the component, to panes and pointers, in pixels. */
final class PanePointers {
    /** Distance of what is grabbed where there is no surface under the pointer. */
    private static final double NOTHING_METRES = 8;

    private final EditorSession session;
    private final Supplier<SurfaceSize> size;

    PanePointers(EditorSession session, Supplier<SurfaceSize> size) {
        this.session = session;
        this.size = size;
    }

    double pixels(int points) {
        return points * size.get().pixelsPerPoint();
    }

    Optional<PaneRectangle> pane(MouseEvent event) {
        return session.panes()
                .paneAt(pixels(event.getX()), pixels(event.getY()), session.viewport(), ViewportScene.gap(size));
    }

    Optional<Splitter> splitter(MouseEvent event) {
        return session.panes()
                .splitterAt(pixels(event.getX()), pixels(event.getY()), session.viewport(), ViewportScene.gap(size));
    }

    /** Returns the present place of a pane; empty if it is not visible any more. */
    Optional<PaneRectangle> place(int pane) {
        return session.panes().rectangles(session.viewport(), ViewportScene.gap(size)).stream()
                .filter(rectangle -> rectangle.index() == pane)
                .findFirst();
    }

    Pointer pointer(MouseEvent event, PaneRectangle pane) {
        PaneView view = session.panes().views().get(pane.index());
        return new Pointer(
                view.kind(),
                view.camera(),
                pane.size(),
                pixels(event.getX()) - pane.x(),
                pixels(event.getY()) - pane.y(),
                button(event),
                modifiers(event),
                event.getClickCount());
    }

    private static Button button(MouseEvent event) {
        if (SwingUtilities.isLeftMouseButton(event)) {
            return Button.PRIMARY;
        } else if (SwingUtilities.isRightMouseButton(event)) {
            return Button.SECONDARY;
        }
        return SwingUtilities.isMiddleMouseButton(event) ? Button.MIDDLE : Button.NONE;
    }

    private static Set<Modifier> modifiers(MouseEvent event) {
        Set<Modifier> held = EnumSet.noneOf(Modifier.class);
        if (event.isShiftDown()) {
            held.add(Modifier.SHIFT);
        }
        if (event.isControlDown() || event.isMetaDown() && !SwingUtilities.isRightMouseButton(event)) {
            held.add(Modifier.CONTROL);
        }
        if (event.isAltDown()) {
            held.add(Modifier.ALT);
        }
        return held;
    }

    /** Returns the nearest surface under the pointer, or a place before the camera. */
    Vec3 grabbed(Pointer pointer) {
        return surface(pointer).orElseGet(() -> pointer.ray().at(NOTHING_METRES));
    }

    /** Returns the place that the status bar names: in a plan its plane, otherwise a surface or the plane y = 0. */
    Optional<Vec3> shown(Pointer pointer) {
        if (pointer.kind() != PaneKind.PERSPECTIVE) {
            Ray ray = pointer.ray();
            Vec3 centre = session.panes().activeView().plan().centre();
            return pointer.onPlane(centre, new Vec3(ray.directionX(), ray.directionY(), ray.directionZ()));
        }
        return surface(pointer).or(() -> pointer.onPlane(Vec3.ZERO, new Vec3(0, 1, 0)));
    }

    private Optional<Vec3> surface(Pointer pointer) {
        return session.context().picker().surfaces(pointer.ray()).stream()
                .findFirst()
                .map(Picker.Pick::point);
    }
}
