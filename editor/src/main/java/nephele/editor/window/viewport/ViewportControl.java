package nephele.editor.window.viewport;

import java.awt.Component;
import java.awt.Cursor;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javax.swing.SwingUtilities;
import nephele.editor.document.Picker;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PaneLayout.Splitter;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.session.EditorSession;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** Sends the mouse, as a pointer in a pane, to the tool, to the cameras and to the splitters between panes. */
final class ViewportControl extends MouseAdapter {
    /** Distance of what is grabbed where there is no surface under the pointer. */
    private static final double NOTHING_METRES = 8;

    private static final double DEGREES_PER_POINT = 0.2;

    private final EditorSession session;
    private final Supplier<SurfaceSize> size;
    private final Consumer<Optional<Vec3>> pointed;
    private final Flight flight = new Flight(this::fly);
    private Splitter splitter;

    /** What the drag of the right or the middle button does to the camera; {@code null} without one. */
    private Motion motion;

    /** The point under the pointer when the button was pressed. */
    private Vec3 grabbed;

    private int pane;
    private PaneSize paneSize;
    private MouseEvent last;

    /** The kind of movement of a camera. */
    private enum Motion {
        LOOK,
        ORBIT,
        PAN
    }

    /** @param pointed receives the place under the pointer after each movement, empty outside */
    ViewportControl(EditorSession session, Supplier<SurfaceSize> size, Consumer<Optional<Vec3>> pointed) {
        this.session = session;
        this.size = size;
        this.pointed = pointed;
    }

    /** Returns the pointer at a point of a component. */
    Optional<Pointer> pointer(Point point, Component of) {
        MouseEvent event = new MouseEvent(of, MouseEvent.MOUSE_MOVED, 0, 0, point.x, point.y, 0, false);
        return pane(event).map(place -> pointer(event, place));
    }

    private double pixels(int points) {
        return points * size.get().pixelsPerPoint();
    }

    private Optional<PaneRectangle> pane(MouseEvent event) {
        return session.panes()
                .paneAt(pixels(event.getX()), pixels(event.getY()), session.viewport(), ViewportScene.gap(size));
    }

    private Optional<Splitter> splitter(MouseEvent event) {
        return session.panes()
                .splitterAt(pixels(event.getX()), pixels(event.getY()), session.viewport(), ViewportScene.gap(size));
    }

    /** Returns the present place of a pane; empty if it is not visible any more. */
    private Optional<PaneRectangle> place(int index) {
        return session.panes().rectangles(session.viewport(), ViewportScene.gap(size)).stream()
                .filter(rectangle -> rectangle.index() == index)
                .findFirst();
    }

    private Pointer pointer(MouseEvent event, PaneRectangle place) {
        PaneView view = session.panes().views().get(place.index());
        return new Pointer(
                view.kind(),
                view.camera(),
                place.size(),
                pixels(event.getX()) - place.x(),
                pixels(event.getY()) - place.y(),
                modifiers(event),
                event.getClickCount());
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
    private Vec3 grabbed(Pointer pointer) {
        return surface(pointer).orElseGet(() -> pointer.ray().at(NOTHING_METRES));
    }

    /** Returns the place that the status bar names: in a plan its plane, otherwise a surface or the plane y = 0. */
    private Optional<Vec3> placeUnder(Pointer pointer) {
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

    private boolean isIdle() {
        return splitter == null && motion == null && !session.drag().isOn();
    }

    @Override
    public void mousePressed(MouseEvent event) {
        if (!isIdle()) {
            return;
        }
        splitter = splitter(event).orElse(null);
        Optional<PaneRectangle> place = pane(event);
        if (splitter != null || place.isEmpty()) {
            return;
        }
        activate(place.get());
        pane = place.get().index();
        last = event;
        Pointer pointer = pointer(event, place.get());
        if (SwingUtilities.isLeftMouseButton(event)) {
            session.drag().press(pointer);
            report(pointer);
        } else {
            boolean pans = pointer.isPlan() || SwingUtilities.isMiddleMouseButton(event);
            motion = pans ? Motion.PAN : pointer.isHeld(Modifier.ALT) ? Motion.ORBIT : Motion.LOOK;
            grabbed = grabbed(pointer);
            paneSize = pointer.size();
            if (motion == Motion.LOOK) {
                flight.begin();
            }
        }
    }

    private void activate(PaneRectangle place) {
        if (session.panes().active() != place.index()) {
            session.panes(layout -> layout.withActive(place.index()));
        }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (splitter != null) {
            Splitter dragged = splitter;
            double x = pixels(event.getX());
            double y = pixels(event.getY());
            session.panes(layout -> layout.split(dragged, x, y, session.viewport()));
        } else if (motion != null) {
            double across = pixels(event.getX() - last.getX());
            double down = pixels(event.getY() - last.getY());
            look(before -> moved(before, across, down));
            last = event;
        } else if (session.drag().isOn()) {
            place(pane).map(place -> pointer(event, place)).ifPresent(pointer -> {
                session.drag().move(pointer);
                report(pointer);
            });
        }
    }

    /** Returns the camera after a movement of the pointer by pixels to the right and down. */
    private PaneCamera moved(PaneCamera camera, double across, double down) {
        if (camera instanceof PlanCamera plan) {
            return PlanCamera.pan(plan, across, down);
        }
        PerspectiveCamera eye = (PerspectiveCamera) camera;
        double degrees = DEGREES_PER_POINT / ViewportScene.pixelsPerPoint(size.get());
        return switch (motion) {
            case LOOK -> PerspectiveCamera.look(eye, across, down, degrees);
            case ORBIT -> PerspectiveCamera.orbit(eye, grabbed, across * degrees * 2, down * degrees * 2);
            case PAN -> PerspectiveCamera.pan(eye, across, down, grabbed, paneSize);
        };
    }

    private void look(UnaryOperator<PaneCamera> change) {
        PaneView view = session.panes().views().get(pane);
        PaneView moved = view.with(change.apply(view.camera()));
        session.panes(layout -> layout.with(pane, moved).plansLinked());
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        boolean isOfTool = session.drag().isOn();
        if (isOfTool && SwingUtilities.isLeftMouseButton(event)) {
            place(pane).map(place -> pointer(event, place)).ifPresentOrElse(this::release, session.drag()::cancel);
        } else if (!isOfTool) {
            flight.end();
            splitter = null;
            motion = null;
        }
    }

    private void release(Pointer pointer) {
        session.drag().release(pointer);
        report(pointer);
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        event.getComponent().setCursor(cursor(splitter(event)));
        Optional<PaneRectangle> place = pane(event);
        if (place.isPresent() && isIdle()) {
            activate(place.get());
            Pointer pointer = pointer(event, place.get());
            session.tool().moved(pointer);
            report(pointer);
        }
    }

    private static Cursor cursor(Optional<Splitter> under) {
        if (under.isEmpty()) {
            return Cursor.getDefaultCursor();
        }
        return Cursor.getPredefinedCursor(
                switch (under.get()) {
                    case COLUMNS -> Cursor.E_RESIZE_CURSOR;
                    case ROWS -> Cursor.N_RESIZE_CURSOR;
                    case BOTH -> Cursor.MOVE_CURSOR;
                });
    }

    @Override
    public void mouseExited(MouseEvent event) {
        if (isIdle()) {
            session.tool().left();
        }
        pointed.accept(Optional.empty());
    }

    private void report(Pointer pointer) {
        pointed.accept(placeUnder(pointer));
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        double notches = -event.getPreciseWheelRotation();
        if (flight.isOn()) {
            flight.faster(notches);
            return;
        }
        Optional<PaneRectangle> place = pane(event);
        if (place.isEmpty() || !isIdle()) {
            return;
        }
        activate(place.get());
        pane = place.get().index();
        Pointer pointer = pointer(event, place.get());
        look(before -> wheeled(before, notches, pointer));
    }

    private PaneCamera wheeled(PaneCamera before, double notches, Pointer pointer) {
        if (before instanceof PlanCamera plan) {
            return PlanCamera.zoom(plan, notches, pointer.x(), pointer.y(), pointer.size());
        }
        Ray sight = pointer.ray();
        Vec3 eye = ((PerspectiveCamera) before).eye();
        double distance = grabbed(pointer).minus(eye).length();
        return PerspectiveCamera.dolly((PerspectiveCamera) before, notches, sight, distance);
    }

    private void fly(Vec3 keys, double metres) {
        look(before -> before instanceof PerspectiveCamera eye ? PerspectiveCamera.fly(eye, keys, metres) : before);
    }

    /** Takes a key that belongs to the flight or to the tool; returns false for any other. */
    boolean key(KeyEvent event) {
        if (flight.key(event)) {
            return true;
        }
        if (event.getID() != KeyEvent.KEY_PRESSED
                || event.getModifiersEx() != 0 && !session.drag().isOn()) {
            return false;
        }
        return switch (event.getKeyCode()) {
            case KeyEvent.VK_ESCAPE -> isCancelled();
            case KeyEvent.VK_ENTER -> session.tool().confirm();
            default -> false;
        };
    }

    private boolean isCancelled() {
        boolean isBusy = session.drag().isOn()
                || session.document().isDragging()
                || !session.tool().marks().isEmpty();
        if (isBusy) {
            session.drag().cancel();
            session.tool().cancel();
            session.document().cancelDrag();
            pointed.accept(Optional.empty());
        }
        return isBusy;
    }
}
