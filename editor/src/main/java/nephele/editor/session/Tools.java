package nephele.editor.session;

import java.util.List;
import java.util.Optional;
import nephele.editor.tool.ToolEntry;
import nephele.editor.tool.brush.DrawBrushTool;
import nephele.editor.tool.clip.ClipTool;
import nephele.editor.tool.extrude.ExtrudeTool;
import nephele.editor.tool.measure.MeasureTool;
import nephele.editor.tool.paint.PaintTool;
import nephele.editor.tool.place.PlaceTool;
import nephele.editor.tool.portal.PortalTool;
import nephele.editor.tool.portalable.PortalableTool;
import nephele.editor.tool.select.SelectTool;
import nephele.editor.tool.sun.SunTool;
import nephele.editor.tool.terrain.TerrainTool;
import nephele.editor.tool.transform.TransformTool;
import nephele.editor.tool.vertex.VertexTool;

/** All tools in the order of the toolbar; the only registration. */
public final class Tools {
    public static final List<ToolEntry> ALL = List.of(
            SelectTool.ENTRY,
            TransformTool.MOVE,
            TransformTool.ROTATE,
            TransformTool.SCALE,
            DrawBrushTool.ENTRY,
            ExtrudeTool.ENTRY,
            ClipTool.ENTRY,
            VertexTool.ENTRY,
            PlaceTool.ENTRY,
            PortalTool.ENTRY,
            PaintTool.ENTRY,
            PortalableTool.ENTRY,
            TerrainTool.ENTRY,
            SunTool.ENTRY,
            MeasureTool.ENTRY);

    private Tools() {}

    public static Optional<ToolEntry> named(String id) {
        return ALL.stream().filter(entry -> entry.id().equals(id)).findFirst();
    }
}
