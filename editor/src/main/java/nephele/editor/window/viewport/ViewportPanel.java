package nephele.editor.window.viewport;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinWorkerThread;
import java.util.function.Consumer;
import javax.swing.JPanel;
import nephele.editor.document.Registration;
import nephele.editor.draw.BackgroundWork;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.tool.Pointer;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;

/** The viewport of a session: its panes, drawn on a surface, and the mouse in them. It draws only after changes. */
public final class ViewportPanel extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1;

    /** A single thread, so that a core is left for the user; streams that it begins stay on it. */
    private final transient ForkJoinPool baking;

    private final transient ViewportScene scene;
    private final transient ViewportSurface surface;
    private final transient ViewportControl control;
    private final transient Registration registration;

    /**
     * Creates a viewport that follows the session.
     *
     * @param pointed receives the place under the pointer, empty outside
     * @param report receives a line for each thing that cannot be shown
     */
    public ViewportPanel(EditorSession session, Consumer<Optional<Vec3>> pointed, Consumer<String> report) {
        this(session, pointed, report, ForkJoinPool.commonPool());
    }

    /** @param background runs what takes long, such as the light of the sky */
    ViewportPanel(
            EditorSession session, Consumer<Optional<Vec3>> pointed, Consumer<String> report, Executor background) {
        super(new BorderLayout());
        baking = new ForkJoinPool(1, ViewportPanel::bakeThread, null, false);
        scene = new ViewportScene(session, new BackgroundWork(background, baking, this::repaintSoon), report);
        surface = new ViewportSurface(scene, GlContext::offscreen);
        control = new ViewportControl(session, surface::size, place -> {
            pointed.accept(place);
            surface.repaintSoon();
        });
        surface.listen(control, new KeyAdapter() {});
        MouseAdapter focusing = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                surface.requestFocus();
            }
        };
        surface.listen(focusing, new KeyAdapter() {});
        registration = session.listen(change -> {
            if (change != SessionChange.STATUS) {
                surface.repaintSoon();
            }
        });
        setMinimumSize(new Dimension(80, 60));
        setPreferredSize(new Dimension(640, 400));
        add(surface.component());
    }

    private static ForkJoinWorkerThread bakeThread(ForkJoinPool pool) {
        ForkJoinWorkerThread made = ForkJoinPool.defaultForkJoinWorkerThreadFactory.newThread(pool);
        made.setName("bake");
        made.setPriority(Thread.MIN_PRIORITY);
        return made;
    }

    private void repaintSoon() {
        surface.repaintSoon();
    }

    /** Takes a key of a flight or of the tool's drag; returns false for any other. */
    public boolean key(KeyEvent event) {
        return control.key(event);
    }

    /** Returns the pointer at a point of the surface's component; empty between panes and outside. */
    public Optional<Pointer> pointer(Point point) {
        return control.pointer(point, surface.component());
    }

    /** Returns the surface, whose component receives the mouse. */
    public ViewportSurface surface() {
        return surface;
    }

    /** Draws now, with all edits taken over, waits for it and returns the picture: for what is kept. */
    public BufferedImage picture() {
        return scene.complete(surface::picture);
    }

    @Override
    public void close() {
        registration.close();
        surface.close();
        surface.closed().whenComplete((nothing, failed) -> baking.shutdownNow());
    }
}
