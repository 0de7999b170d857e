package nephele.editor.surface;

import java.awt.Component;
import java.awt.event.KeyListener;
import java.awt.event.MouseAdapter;
import java.awt.image.BufferedImage;

/** A component that shows what a {@link SurfacePainter} draws. */
public interface ViewportSurface extends AutoCloseable {
    /** Returns the component to add to a window. */
    Component component();

    /** Sends the user's input to listeners; positions are in points of the picture. */
    default void listen(MouseAdapter mouse, KeyListener keys) {
        Listening.add(component(), mouse, keys);
    }

    /** Asks for the keyboard's focus. */
    default void requestFocus() {
        component().requestFocusInWindow();
    }

    /** Returns the present size. */
    default SurfaceSize size() {
        return SurfaceSize.of(component());
    }

    /** Draws soon; several calls before that are one. May be called on every thread. */
    void repaintSoon();

    /** Draws now, and returns the picture. Only on the surface's thread. */
    BufferedImage picture();

    /** Closes what was made with the context, and the context. Only on the surface's thread. */
    @Override
    void close();
}
