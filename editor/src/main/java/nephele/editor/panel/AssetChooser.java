package nephele.editor.panel;

import java.util.Optional;

/** Asks the user for an asset. */
@FunctionalInterface
public interface AssetChooser {
    /** Returns the chosen asset id; empty if the user cancels. */
    Optional<String> choose(String current);
}
