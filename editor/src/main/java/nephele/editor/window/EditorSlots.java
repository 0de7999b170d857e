package nephele.editor.window;

import java.util.List;
import javax.swing.JComponent;

/**
 * The parts that the caller puts around the viewport.
 *
 * @param top above the viewport, such as the guide; {@code null} for none
 * @param left such as the outliner; {@code null} for none
 * @param right such as the inspector; {@code null} for none
 * @param bottom such as tabs of problems and history; {@code null} for none
 * @param mainActions ids of the actions in the toolbar, in order; those that do not exist are left out
 */
public record EditorSlots(
        JComponent top, JComponent left, JComponent right, JComponent bottom, List<String> mainActions) {}
