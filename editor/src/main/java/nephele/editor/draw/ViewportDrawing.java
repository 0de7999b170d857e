package nephele.editor.draw;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.editor.draw.ViewportFrame.Look;
import nephele.editor.draw.ViewportFrame.Pane;
import nephele.editor.pane.Mark;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.ViewMode;
import nephele.engine.level.Level;
import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.pass.overlay.FontAtlas;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.engine.render.pass.overlay.OverlayPass;
import nephele.engine.scene.light.bake.BakedLight;

/**
 * Draws viewport frames and keeps what follows from the level from one frame to the next: an edit renews what changed,
 * and a pane whose content has not changed keeps its picture. Everything runs on the context's thread.
 */
public final class ViewportDrawing implements AutoCloseable {
    private static final DisplayColour ACTIVE = DisplayColour.opaque(0x4d9de0);
    private static final double ACTIVE_POINTS = 2;

    private final GlContext gl;
    private final BackgroundWork work;
    private final PaneDrawing panes;
    private final OverlayPass frameOverlay;
    private final OverlayCanvas frameCanvas;
    private final Map<Integer, DrawnPane> drawnPanes = new HashMap<>();
    private DrawnLevel drawn;

    /** A pane's picture with all that it was drawn from; the same of it give the same picture. */
    private record DrawnPane(
            RenderTarget picture,
            Level level,
            Pane pane,
            List<Mark> marks,
            Look look,
            BakedLight light,
            double changed) {
        /** Levels are compared by identity: an edit makes a new one. */
        boolean isSame(DrawnPane other) {
            return level == other.level
                    && light == other.light
                    && changed == other.changed
                    && pane.equals(other.pane)
                    && look.equals(other.look)
                    && marks.equals(other.marks);
        }
    }

    /** Creates an empty drawing. */
    public ViewportDrawing(GlContext gl, BackgroundWork work) {
        this.gl = gl;
        this.work = work;
        panes = new PaneDrawing(gl);
        FontAtlas letters = new FontAtlas();
        frameOverlay = new OverlayPass(gl, letters);
        frameCanvas = new OverlayCanvas(letters);
    }

    /** Draws a frame over the whole target, with all edits taken over. */
    public void draw(ViewportFrame frame, RenderTarget target) {
        draw(frame, target, Double.POSITIVE_INFINITY);
    }

    /**
     * Draws a frame over the whole target.
     *
     * @param seconds that have passed for edits which are taken over gradually since the last frame
     */
    public void draw(ViewportFrame frame, RenderTarget target, double seconds) {
        if (target.width() == 0 || target.height() == 0) {
            return;
        }
        follow(frame, seconds);
        drawnPanes.entrySet().removeIf(entry -> isStale(entry.getKey(), entry.getValue(), frame));
        for (Pane pane : frame.panes()) {
            draw(pane, frame);
        }
        if (frame.isSettled()) {
            frame.panes().stream()
                    .filter(ViewportDrawing::isLit)
                    .findFirst()
                    .ifPresent(pane -> drawn.bake(
                            frame.bakesLight(), pane.view().perspective().eye()));
        }
        PaneDrawing.clear(target, frame.look().background().gapRgb());
        for (Pane pane : frame.panes()) {
            PaneRectangle place = pane.place();
            int bottom = target.height() - place.y() - place.height();
            drawnPanes.get(place.index()).picture.copyInto(target, place.x(), bottom);
        }
        drawActive(frame, target);
    }

    /** Returns true while an edit is taken over gradually: the next frame differs from the last one. */
    public boolean isChanging() {
        return drawn != null && drawnPanes.values().stream().anyMatch(pane -> changed(pane.pane) < 1);
    }

    private double changed(Pane pane) {
        return drawn.changed(pane.view().mode());
    }

    private void follow(ViewportFrame frame, double seconds) {
        Background behind = frame.look().background();
        if (drawn == null || !drawn.follows(frame.assets(), behind)) {
            closeLevel();
            drawn = new DrawnLevel(gl, frame.assets(), behind, work);
        }
        drawn.elapse(seconds);
        drawn.show(frame.level());
    }

    private void closeLevel() {
        if (drawn != null) {
            drawn.close();
            drawn = null;
        }
        drawnPanes.values().forEach(pane -> pane.picture.close());
        drawnPanes.clear();
    }

    /** Closes the picture of a pane that is gone or has another size. */
    private static boolean isStale(int index, DrawnPane pane, ViewportFrame frame) {
        boolean isNeeded = frame.panes().stream()
                .anyMatch(wanted -> wanted.place().index() == index
                        && wanted.place().width() == pane.picture.width()
                        && wanted.place().height() == pane.picture.height());
        if (!isNeeded) {
            pane.picture.close();
        }
        return !isNeeded;
    }

    private static boolean isLit(Pane pane) {
        return pane.view().kind() == PaneKind.PERSPECTIVE && pane.view().mode() == ViewMode.LIT;
    }

    private void draw(Pane pane, ViewportFrame frame) {
        int index = pane.place().index();
        BakedLight light = isLit(pane) ? drawn.light().light() : null;
        DrawnPane before = drawnPanes.get(index);
        RenderTarget picture = before != null
                ? before.picture
                : RenderTarget.picture(
                        gl,
                        "pane " + index,
                        PixelFormat.RGBA8,
                        pane.place().width(),
                        pane.place().height());
        DrawnPane now = new DrawnPane(picture, drawn.wanted(), pane, frame.marks(), frame.look(), light, changed(pane));
        drawnPanes.put(index, now);
        if (before == null || !before.isSame(now)) {
            panes.draw(drawn, pane, frame, picture);
        }
    }

    private void drawActive(ViewportFrame frame, RenderTarget target) {
        if (frame.panes().size() < 2) {
            return;
        }
        PaneRectangle place = frame.panes().get(frame.active()).place();
        double scale = frame.look().pixelsPerPoint();
        double x = place.x() / scale;
        double y = place.y() / scale;
        double width = place.width() / scale;
        double height = place.height() / scale;
        frameCanvas.begin(scale);
        frameCanvas.rectangle(x, y, width, ACTIVE_POINTS, ACTIVE);
        frameCanvas.rectangle(x, y + height - ACTIVE_POINTS, width, ACTIVE_POINTS, ACTIVE);
        frameCanvas.rectangle(x, y, ACTIVE_POINTS, height, ACTIVE);
        frameCanvas.rectangle(x + width - ACTIVE_POINTS, y, ACTIVE_POINTS, height, ACTIVE);
        frameOverlay.draw(frameCanvas, target);
    }

    /** Returns what of the last frame's level could not be drawn, a line each: files that cannot be read, broken solids. */
    public List<String> messages() {
        return drawn == null ? List.of() : drawn.messages();
    }

    /** Returns true if the last frame's level had bounced light when it was opened. */
    public boolean isLightKnown() {
        return drawn != null && drawn.light().isKnown();
    }

    /** Returns how far the bake of the last frame's light is. */
    public LightProgress lightProgress() {
        return drawn == null ? LightProgress.NONE : drawn.light().progress();
    }

    @Override
    public void close() {
        closeLevel();
        panes.close();
        frameOverlay.close();
    }
}
