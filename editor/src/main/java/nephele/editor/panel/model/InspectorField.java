package nephele.editor.panel.model;

import java.util.List;
import java.util.Objects;
import nephele.editor.record.FieldKind;
import nephele.editor.text.FieldWords;
import nephele.editor.text.Words;

/**
 * A line of the inspector: a component, or an entry of a list or table, of all selected records that have it.
 *
 * @param path from the selected record
 * @param depth steps of indentation
 * @param title in words of the record
 * @param values the different values of the records, in the order of the selection; may have {@code null}
 * @param isEntry true for an entry of a list or table
 */
public record InspectorField(
        RecordPath path, FieldType type, int depth, String title, List<Object> values, boolean isEntry) {
    /** Returns the title for users: the component's words, or the number or key of an entry. */
    public Words words() {
        return isEntry ? Words.same(title) : FieldWords.of(type.field());
    }

    /** Returns true if the records differ in the value. */
    public boolean isMixed() {
        return values.size() > 1;
    }

    /** Returns the common value; {@code null} if it is absent or mixed. */
    public Object value() {
        return isMixed() ? null : values.get(0);
    }

    /** Returns true if no record has a value. */
    public boolean isUnset() {
        return !isMixed() && values.get(0) == null;
    }

    /** Returns true if a reset would change something. */
    public boolean canReset() {
        return !isEntry && type.hasDefault() && (isMixed() || !Objects.equals(value(), type.defaultValue()));
    }

    /** Returns true if an editor of the same make shows the other field: only the values may differ. */
    public boolean hasSameForm(InspectorField other) {
        return path.equals(other.path)
                && type.equals(other.type)
                && depth == other.depth
                && title.equals(other.title)
                && isEntry == other.isEntry;
    }

    /** Returns true for the id of the record itself. */
    public boolean isId() {
        return path.steps().size() == 1 && type.field().isId();
    }

    /** Returns true for a heading over other lines. */
    public boolean isHeading() {
        return type.kind() == FieldKind.RECORD
                || type.kind() == FieldKind.VARIANT
                || type.kind() == FieldKind.LIST
                || type.kind() == FieldKind.TABLE;
    }
}
