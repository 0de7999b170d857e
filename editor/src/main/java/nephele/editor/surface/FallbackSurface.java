package nephele.editor.surface;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.KeyListener;
import java.awt.event.MouseAdapter;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JPanel;

/** A canvas, or an offscreen picture in its place from the moment on when the canvas turns out to get no context. */
final class FallbackSurface implements ViewportSurface {
    private final JPanel place = new JPanel(new BorderLayout());
    private final Supplier<ViewportSurface> fallback;
    private final Consumer<String> report;
    private final List<Listeners> listeners = new ArrayList<>();
    private ViewportSurface shown;

    private record Listeners(MouseAdapter mouse, KeyListener keys) {}

    /**
     * Creates a surface.
     *
     * @param fallback makes the surface that replaces the canvas
     * @param report receives the reason why it was replaced
     */
    FallbackSurface(SurfacePainter painter, Supplier<ViewportSurface> fallback, Consumer<String> report) {
        this.fallback = fallback;
        this.report = report;
        place.setMinimumSize(new Dimension(1, 1));
        shown = new AwtGlSurface(painter, this::replace);
        place.add(shown.component());
    }

    private void replace(String reason) {
        boolean hadFocus = shown.component().isFocusOwner();
        place.remove(shown.component());
        shown = fallback.get();
        listeners.forEach(each -> shown.listen(each.mouse, each.keys));
        place.add(shown.component());
        place.revalidate();
        place.validate();
        place.repaint();
        if (hadFocus) {
            shown.requestFocus();
        }
        report.accept(reason);
    }

    @Override
    public Component component() {
        return place;
    }

    @Override
    public void listen(MouseAdapter mouse, KeyListener keys) {
        listeners.add(new Listeners(mouse, keys));
        shown.listen(mouse, keys);
    }

    @Override
    public void requestFocus() {
        shown.requestFocus();
    }

    @Override
    public SurfaceSize size() {
        return shown.size();
    }

    @Override
    public void repaintSoon() {
        shown.repaintSoon();
    }

    @Override
    public BufferedImage picture() {
        ViewportSurface before = shown;
        BufferedImage picture = before.picture();
        return shown == before ? picture : shown.picture();
    }

    @Override
    public void close() {
        shown.close();
    }
}
