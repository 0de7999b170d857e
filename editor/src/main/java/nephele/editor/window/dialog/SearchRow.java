package nephele.editor.window.dialog;

import javax.swing.Icon;

/**
 * The row of a search list for an element.
 *
 * @param aside what it belongs to, in a column of its own; may be empty
 * @param trailing such as its key, at the right end; may be empty
 * @param icon {@code null} for none
 */
public record SearchRow(String title, String aside, String trailing, Icon icon, boolean isEnabled) {
    /** Returns a row with a title alone. */
    public static SearchRow of(String title, String aside) {
        return new SearchRow(title, aside, "", null, true);
    }
}
