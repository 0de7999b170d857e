package nephele.editor.action;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** All actions in the order of the menus; the only registration. */
public final class Actions {
    public static final List<EditorAction> ALL = Stream.of(
                    FileActions.ALL,
                    EditActions.ALL,
                    EntityActions.ALL,
                    SelectActions.ALL,
                    BrushActions.ALL,
                    TextureActions.ALL,
                    ViewActions.ALL,
                    ToolActions.OPTIONS,
                    TerrainActions.ALL,
                    ToolActions.TOOLS,
                    PlayActions.ALL,
                    ProvingActions.ALL,
                    ViewActions.OF_WINDOW)
            .flatMap(List::stream)
            .toList();

    private Actions() {}

    public static Optional<EditorAction> named(String id) {
        return ALL.stream().filter(action -> action.id().equals(id)).findFirst();
    }
}
