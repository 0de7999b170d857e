package nephele.editor.panel;

import javax.swing.JComponent;
import nephele.editor.panel.model.InspectorField;

/** The component that shows and changes the value of a field. */
interface FieldEditor {
    JComponent component();

    /** Shows a field of the same form; an edit in progress is left alone by equal values. */
    void show(InspectorField field);
}
