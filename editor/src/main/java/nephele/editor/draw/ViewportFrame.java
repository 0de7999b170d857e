package nephele.editor.draw;

import java.util.List;
import nephele.editor.pane.Mark;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.ViewMode;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;

/**
 * Everything that a viewport shows at one instant.
 *
 * @param assets another object means that files may have changed: everything is read again
 * @param active index into {@code panes}; that pane has a frame
 * @param marks drawn in every pane
 * @param isSettled false during a drag; light that takes long is computed only for settled levels
 * @param bakesLight whether light that bounces is baked in the background
 */
public record ViewportFrame(
        Level level,
        AssetSource assets,
        List<Pane> panes,
        int active,
        List<Mark> marks,
        Look look,
        boolean isSettled,
        boolean bakesLight) {
    public ViewportFrame {
        panes = List.copyOf(panes);
    }

    /** Returns the frame with other marks in every pane. */
    public ViewportFrame with(List<Mark> others) {
        return new ViewportFrame(level, assets, panes, active, others, look, isSettled, bakesLight);
    }

    /** Returns the frame with the edges of what its panes show, which are drawn soon. */
    public ViewportFrame withEdgesOnly() {
        List<Pane> edges = panes.stream()
                .map(pane -> new Pane(
                        pane.place(), pane.view().with(ViewMode.WIREFRAME), pane.caption(), pane.marks(), pane.inset()))
                .toList();
        return new ViewportFrame(level, assets, edges, active, marks, look, isSettled, bakesLight);
    }

    /**
     * One pane.
     *
     * @param place in pixels of the target, from the upper left corner
     * @param caption in the user's language; empty for none
     * @param marks drawn in this pane only
     */
    public record Pane(PaneRectangle place, PaneView view, String caption, List<Mark> marks, PaneInset inset) {
        /** Makes a pane without an inset. */
        public Pane(PaneRectangle place, PaneView view, String caption, List<Mark> marks) {
            this(place, view, caption, marks, PaneInset.NONE);
        }
    }

    /**
     * The look of the viewport.
     *
     * @param gridMetres spacing of the grid to which the editor snaps; lines that would be too close are left out
     * @param hasGuideLines true if perspective panes have the grid on the plane y = 0, and lit ones the edges of brushes
     * @param pixelsPerPoint 1 on an ordinary display, 2 at 200 %
     */
    public record Look(Background background, double gridMetres, boolean hasGuideLines, double pixelsPerPoint) {}
}
