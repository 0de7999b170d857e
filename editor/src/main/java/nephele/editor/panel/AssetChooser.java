package nephele.editor.panel;

import java.util.Optional;
import javax.swing.Icon;
import nephele.editor.panel.model.InspectorField;

/** Asks the user for an asset. */
@FunctionalInterface
public interface AssetChooser {
    /**
     * Returns the chosen asset id; empty if the user cancels.
     *
     * @param current id, possibly empty
     */
    Optional<String> choose(InspectorField field, String current);

    /** Returns a small picture of an asset; empty if it is no picture. */
    default Optional<Icon> picture(String assetId) {
        return Optional.empty();
    }
}
