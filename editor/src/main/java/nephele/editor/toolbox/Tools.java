package nephele.editor.toolbox;

import java.util.List;
import java.util.Optional;
import nephele.editor.tool.ToolEntry;
import nephele.editor.tool.brush.DrawBrushTool;
import nephele.editor.tool.clip.ClipTool;
import nephele.editor.tool.extrude.ExtrudeTool;
import nephele.editor.tool.select.SelectTool;
import nephele.editor.tool.transform.TransformTool;
import nephele.editor.tool.vertex.VertexTool;

/** All tools in the order of the toolbar; the only registration. */
public final class Tools {
    public static final List<ToolEntry> ALL = List.of(
            SelectTool.ENTRY,
            DrawBrushTool.ENTRY,
            TransformTool.MOVE,
            TransformTool.ROTATE,
            TransformTool.SCALE,
            ExtrudeTool.ENTRY,
            ClipTool.ENTRY,
            VertexTool.ENTRY);

    private Tools() {}

    public static Optional<ToolEntry> named(String id) {
        return ALL.stream().filter(entry -> entry.id().equals(id)).findFirst();
    }
}
