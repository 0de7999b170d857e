package nephele.editor.toolbox;

import java.util.List;
import java.util.Optional;
import nephele.editor.tool.ToolEntry;
import nephele.editor.tool.select.SelectTool;

/** All tools in the order of the toolbar; the only registration. */
public final class Tools {
    public static final List<ToolEntry> ALL = List.of(SelectTool.ENTRY);

    private Tools() {}

    public static Optional<ToolEntry> named(String id) {
        return ALL.stream().filter(entry -> entry.id().equals(id)).findFirst();
    }
}
