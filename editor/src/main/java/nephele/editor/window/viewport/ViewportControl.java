package nephele.editor.window.viewport;

import java.awt.Component;
import java.awt.Cursor;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javax.swing.SwingUtilities;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PaneLayout.Splitter;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.session.EditorSession;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Button;
import nephele.editor.tool.Pointer.Modifier;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** Sends the mouse to the tool, to the cameras and to the splitters between panes. */
final class ViewportControl extends MouseAdapter {
    private final EditorSession session;
    private final PanePointers pointers;
    private final Supplier<SurfaceSize> size;
    private final Consumer<Optional<Vec3>> pointed;
    private final Flight flight = new Flight(this::fly);
    private Splitter splitter;
    private CameraDrag camera;
    private int pane;
    private MouseEvent last;

    /** @param pointed receives the place under the pointer after each movement, empty outside */
    ViewportControl(EditorSession session, Supplier<SurfaceSize> size, Consumer<Optional<Vec3>> pointed) {
        this.session = session;
        this.size = size;
        this.pointed = pointed;
        pointers = new PanePointers(session, size);
    }

    /** Returns the pointer at a point of a component. */
    Optional<Pointer> pointer(Point point, Component of) {
        MouseEvent event = new MouseEvent(of, MouseEvent.MOUSE_MOVED, 0, 0, point.x, point.y, 0, false);
        return pointers.pane(event).map(place -> pointers.pointer(event, place));
    }

    private boolean isIdle() {
        return splitter == null && camera == null && !session.drag().isOn();
    }

    @Override
    public void mousePressed(MouseEvent event) {
        if (!isIdle()) {
            return;
        }
        splitter = pointers.splitter(event).orElse(null);
        Optional<PaneRectangle> place = pointers.pane(event);
        if (splitter != null || place.isEmpty()) {
            return;
        }
        activate(place.get());
        pane = place.get().index();
        last = event;
        Pointer pointer = pointers.pointer(event, place.get());
        if (SwingUtilities.isLeftMouseButton(event)) {
            session.drag().press(pointer);
            told(pointer);
        } else {
            camera = CameraDrag.of(pointer, pointers.grabbed(pointer));
            if (camera.motion() == CameraDrag.Motion.LOOK) {
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
            double x = pointers.pixels(event.getX());
            double y = pointers.pixels(event.getY());
            session.panes(layout -> layout.split(dragged, x, y, session.viewport()));
        } else if (camera != null) {
            double across = pointers.pixels(event.getX() - last.getX());
            double down = pointers.pixels(event.getY() - last.getY());
            look(view -> camera.moved(view, across, down, ViewportScene.pixelsPerPoint(size.get())));
            last = event;
        } else if (session.drag().isOn()) {
            pointers.place(pane).map(place -> pointers.pointer(event, place)).ifPresent(pointer -> {
                session.drag().move(pointer);
                told(pointer);
            });
        }
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
            pointers.place(pane)
                    .map(place -> pointers.pointer(event, place))
                    .ifPresentOrElse(this::release, session.drag()::cancel);
        } else if (!isOfTool) {
            flight.end();
            splitter = null;
            camera = null;
        }
    }

    private void release(Pointer pointer) {
        session.drag().release(pointer);
        told(pointer);
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        event.getComponent().setCursor(cursor(pointers.splitter(event)));
        Optional<PaneRectangle> place = pointers.pane(event);
        if (place.isPresent() && isIdle()) {
            activate(place.get());
            Pointer pointer = pointers.pointer(event, place.get());
            session.tool().moved(pointer);
            told(pointer);
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

    private void told(Pointer pointer) {
        pointed.accept(pointers.shown(pointer));
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        double notches = -event.getPreciseWheelRotation();
        if (flight.isOn()) {
            flight.faster(notches);
            return;
        }
        Optional<PaneRectangle> place = pointers.pane(event);
        if (place.isEmpty() || !isIdle()) {
            return;
        }
        activate(place.get());
        pane = place.get().index();
        Pointer pointer = pointers.pointer(event, place.get());
        look(before -> wheeled(before, notches, pointer));
    }

    private PaneCamera wheeled(PaneCamera before, double notches, Pointer pointer) {
        if (before instanceof PlanCamera plan) {
            return PlanCamera.zoom(plan, notches, pointer.x(), pointer.y(), pointer.size());
        }
        Ray sight = pointer.ray();
        Vec3 eye = ((PerspectiveCamera) before).eye();
        double distance = pointers.grabbed(pointer).minus(eye).length();
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

    /**
     * Moves a camera by a drag of the right or the middle button.
     *
     * @param grabbed the point under the pointer when the button was pressed
     */
    private record CameraDrag(Motion motion, Vec3 grabbed, PaneSize size) {
        private static final double DEGREES_PER_POINT = 0.2;

        /** The kind of movement. */
        enum Motion {
            LOOK,
            ORBIT,
            PAN
        }

        static CameraDrag of(Pointer pointer, Vec3 grabbed) {
            boolean pans = pointer.isPlan() || pointer.button() == Button.MIDDLE;
            Motion motion = pans ? Motion.PAN : pointer.isHeld(Modifier.ALT) ? Motion.ORBIT : Motion.LOOK;
            return new CameraDrag(motion, grabbed, pointer.size());
        }

        /** Returns the camera after a movement of the pointer by pixels to the right and down. */
        PaneCamera moved(PaneCamera camera, double across, double down, double pixelsPerPoint) {
            if (camera instanceof PlanCamera plan) {
                return PlanCamera.pan(plan, across, down);
            }
            PerspectiveCamera eye = (PerspectiveCamera) camera;
            double degrees = DEGREES_PER_POINT / pixelsPerPoint;
            return switch (motion) {
                case LOOK -> PerspectiveCamera.look(eye, across, down, degrees);
                case ORBIT -> PerspectiveCamera.orbit(eye, grabbed, across * degrees * 2, down * degrees * 2);
                case PAN -> PerspectiveCamera.pan(eye, across, down, grabbed, size);
            };
        }
    }
}
