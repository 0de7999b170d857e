package nephele.editor.tool;

import java.util.Set;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.engine.math.Ray;

/**
 * A pointer event in a pane.
 *
 * @param x pixels from the left border of the pane
 * @param y pixels from its upper border
 * @param clicks 2 for a double click
 */
public record Pointer(
        PaneKind kind,
        PaneCamera camera,
        PaneSize size,
        double x,
        double y,
        Button button,
        Set<Modifier> modifiers,
        int clicks) {
    /** A button of the mouse; navigation takes the others before a tool sees them. */
    public enum Button {
        NONE,
        PRIMARY,
        SECONDARY,
        MIDDLE
    }

    /** A key that is held. */
    public enum Modifier {
        SHIFT,
        CONTROL,
        ALT
    }

    /** Returns the ray of sight through the pointer. */
    public Ray ray() {
        return camera.ray(x, y, size);
    }

    public boolean isHeld(Modifier modifier) {
        return modifiers.contains(modifier);
    }

    public boolean isPlan() {
        return kind != PaneKind.PERSPECTIVE;
    }
}
