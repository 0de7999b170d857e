package nephele.editor.action;

import java.util.List;
import java.util.Optional;

/** All actions in the order of the menus; the only registration. */
public final class Actions {
    public static final List<EditorAction> ALL = List.of();

    private Actions() {}

    public static Optional<EditorAction> named(String id) {
        return ALL.stream().filter(action -> action.id().equals(id)).findFirst();
    }
}
