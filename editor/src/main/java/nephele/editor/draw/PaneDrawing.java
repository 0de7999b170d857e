package nephele.editor.draw;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.editor.draw.ViewportFrame.Pane;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.pane.ViewMode;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.line.LineCanvas;
import nephele.engine.render.line.LineDrawing;
import nephele.engine.render.line.LineLayer;
import nephele.engine.render.line.LineProjection;
import nephele.engine.render.pass.overlay.FontAtlas;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.engine.render.pass.overlay.OverlayPass;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;

/** Draws one pane after another: what the level shows, then marks and letters over it. */
final class PaneDrawing implements AutoCloseable {
    private static final double NEAR_METRES = 0.05;
    private static final double CAPTION_BASELINE_POINTS = 34;
    private static final DisplayColour CAPTION = DisplayColour.of(0xe6eaee, 1);
    private static final double AXES_CORNER_POINTS = 34;
    private static final double AXIS_POINTS = 22;
    private static final double AXIS_LETTER_POINTS = 11;
    /** Axes that point to or from the eye have no letter. */
    private static final double LEAST_AXIS_ACROSS = 0.15;

    /** Between surfaces of few colours. */
    private static final DisplayColour EDGES = DisplayColour.of(0x000000, 0.6);
    /** Fainter, since light and textures show most edges. */
    private static final DisplayColour LIT_EDGES = DisplayColour.of(0x000000, 0.3);

    private static final DisplayColour FLOOR = DisplayColour.of(0x8a949e, 1);
    private static final double FLOOR_MINOR_ALPHA = 0.28;
    private static final double FLOOR_MAJOR_ALPHA = 0.5;
    private static final int FLOOR_CELLS = 24;
    private static final int FLOOR_CELLS_PER_MAJOR = 8;
    private static final double LEAST_FLOOR_CELL_METRES = 0.5;

    private final LineDrawing drawing;
    private final OverlayPass overlay;
    private final LineCanvas ground = new LineCanvas();
    private final GroundLines terrains = new GroundLines();
    private final LineCanvas lines = new LineCanvas();
    private final OverlayCanvas texts;

    PaneDrawing(GlContext gl) {
        FontAtlas letters = new FontAtlas();
        drawing = new LineDrawing(gl);
        overlay = new OverlayPass(gl, letters);
        texts = new OverlayCanvas(letters);
    }

    /** Draws a pane over the whole picture. */
    void draw(DrawnLevel level, Pane pane, ViewportFrame frame, RenderTarget picture) {
        PaneCamera camera = pane.view().camera();
        PaneSize size = new PaneSize(picture.width(), picture.height());
        double scale = frame.look().pixelsPerPoint();
        Optional<LevelPicture> surfaces = surfaces(level, pane.view());
        Background background =
                surfaces.isPresent() ? Background.DARK : frame.look().background();
        texts.begin(scale);
        LineProjection projection = camera instanceof PlanCamera plan
                ? plan(level, plan, frame, picture)
                : perspective(level, pane.view(), surfaces, frame, picture);
        lines.begin(projection);
        MarkDrawing marks = new MarkDrawing(lines, texts, background, scale);
        List<Mark> all = new ArrayList<>(frame.marks());
        all.addAll(pane.marks());
        marks.add(all, camera, size, surfaces.isPresent());
        addAxis(camera, new Vec3(1, 0, 0), size, marks, MarkColour.AXIS_X, "x");
        addAxis(camera, new Vec3(0, 1, 0), size, marks, MarkColour.AXIS_Y, "y");
        addAxis(camera, new Vec3(0, 0, 1), size, marks, MarkColour.AXIS_Z, "z");
        if (!pane.caption().isEmpty()) {
            marks.plate(pane.caption(), 10, CAPTION_BASELINE_POINTS, CAPTION);
        }
        pane.inset().draw(texts, size, scale);
        drawing.draw(lines, picture);
        overlay.draw(texts, picture);
    }

    /** Returns the picture of the surfaces; empty where edges are drawn alone, also because the picture cannot be made. */
    private static Optional<LevelPicture> surfaces(DrawnLevel level, PaneView view) {
        boolean hasSurfaces = view.kind() == PaneKind.PERSPECTIVE && view.mode() != ViewMode.WIREFRAME;
        return hasSurfaces ? level.picture(view.mode()) : Optional.empty();
    }

    private LineProjection perspective(
            DrawnLevel level,
            PaneView pane,
            Optional<LevelPicture> surfaces,
            ViewportFrame frame,
            RenderTarget picture) {
        PerspectiveCamera camera = pane.perspective();
        Background background =
                surfaces.isPresent() ? Background.DARK : frame.look().background();
        View view = view(camera, picture.width() / (double) picture.height());
        LineProjection projection = LineProjection.of(view, picture.width(), picture.height());
        if (surfaces.isPresent()) {
            surfaces.get().draw(view, picture);
            edgesBetweenSurfaces(pane.mode(), frame.look().hasGuideLines())
                    .ifPresent(colour -> level.edges(PaneKind.PERSPECTIVE)
                            .draw(projection, colour, LineLayer.BEHIND_SURFACES, picture));
        } else {
            clear(picture, background.rgb());
        }
        ground.begin(projection);
        if (frame.look().hasGuideLines()) {
            addFloorLines(camera.eye(), frame.look().gridMetres(), background);
        }
        drawing.draw(ground, picture);
        if (surfaces.isEmpty()) {
            drawEdges(level, PaneKind.PERSPECTIVE, projection, background, picture);
        }
        return projection;
    }

    private static Optional<DisplayColour> edgesBetweenSurfaces(ViewMode mode, boolean hasGuideLines) {
        return switch (mode) {
            case LIT -> hasGuideLines ? Optional.of(LIT_EDGES) : Optional.empty();
            case UNLIT -> Optional.empty();
            default -> Optional.of(EDGES);
        };
    }

    /** Returns the engine's view of a camera. */
    static View view(PerspectiveCamera camera, double aspect) {
        Projection projection = new Projection(
                Math.toRadians(camera.verticalFovDegrees()), aspect, NEAR_METRES, Double.POSITIVE_INFINITY);
        return new View(
                camera.eye(), camera.right(), camera.up(), camera.forward().negated(), projection);
    }

    private LineProjection plan(DrawnLevel level, PlanCamera camera, ViewportFrame frame, RenderTarget picture) {
        PaneSize size = new PaneSize(picture.width(), picture.height());
        double scale = frame.look().pixelsPerPoint();
        Background background = frame.look().background();
        Basis axes = new Basis(camera.right(), camera.up(), camera.forward().negated());
        LineProjection projection = LineProjection.orthographic(
                camera.centre(), axes, camera.metresPerPixel(), picture.width(), picture.height());
        PlanGrid grid = new PlanGrid(camera, size, frame.look().gridMetres(), background, scale);
        List<HeightField> fields = level.ground();
        clear(picture, background.rgb());
        ground.begin(projection);
        grid.addLines(ground);
        terrains.add(fields, camera, size, background, ground);
        drawing.draw(ground, picture);
        drawEdges(level, camera.kind(), projection, background, picture);
        terrains.addLabels(fields, camera, size, background, scale, texts);
        grid.addLabels(texts);
        return projection;
    }

    private static void drawEdges(
            DrawnLevel level, PaneKind kind, LineProjection projection, Background background, RenderTarget picture) {
        level.edges(kind).draw(projection, background.shade(MarkColour.EDGE), LineLayer.OVER_ALL, picture);
    }

    static void clear(RenderTarget picture, int rgb) {
        picture.clear((rgb >> 16 & 255) / 255f, (rgb >> 8 & 255) / 255f, (rgb & 255) / 255f);
    }

    @Override
    public void close() {
        drawing.close();
        overlay.close();
    }

    /** Adds the direction of an axis of the world, in the lower left corner of the pane. */
    private void addAxis(
            PaneCamera camera, Vec3 axis, PaneSize size, MarkDrawing marks, MarkColour colour, String name) {
        double across = axis.dot(camera.right());
        double upwards = axis.dot(camera.up());
        if (Math.hypot(across, upwards) <= LEAST_AXIS_ACROSS) {
            return;
        }
        double scale = marks.pixelsPerPoint();
        DisplayColour shade = marks.background().shade(colour);
        double[] from = axisPoint(across, upwards, 0, size, scale);
        double[] to = axisPoint(across, upwards, AXIS_POINTS, size, scale);
        double[] end = axisPoint(across, upwards, AXIS_POINTS + 8, size, scale);
        boolean isDark = marks.background() == Background.DARK;
        if (isDark) {
            lines.screenLine(from, to, DisplayColour.of(0, 0.5), 4 * scale);
        }
        lines.screenLine(from, to, shade, 2 * scale);
        if (isDark) {
            DisplayColour shadow = new DisplayColour(0, 0, 0, 0.7f);
            texts.text(end[0] / scale - 2, end[1] / scale + 5, AXIS_LETTER_POINTS, shadow, name);
        }
        texts.text(end[0] / scale - 3, end[1] / scale + 4, AXIS_LETTER_POINTS, shade, name);
    }

    /** Returns a point of an axis that leads across and upwards in the picture, in pixels. */
    private static double[] axisPoint(double across, double upwards, double points, PaneSize size, double scale) {
        double x = AXES_CORNER_POINTS + points * across;
        double y = -AXES_CORNER_POINTS - points * upwards;
        return new double[] {scale * x, size.height() + scale * y};
    }

    /** Adds the grid on the plane y = 0 around the eye of a perspective pane; its spacing grows with the eye's height. */
    private void addFloorLines(Vec3 eye, double gridMetres, Background background) {
        double cell = PlanGrid.doubled(gridMetres, Math.max(LEAST_FLOOR_CELL_METRES, Math.abs(eye.y()) / FLOOR_CELLS));
        long middleX = Math.round(eye.x() / cell);
        long middleZ = Math.round(eye.z() / cell);
        double reach = 2.0 * FLOOR_CELLS * cell;
        for (long i = -2 * FLOOR_CELLS; i <= 2 * FLOOR_CELLS; i++) {
            double x = (middleX + i) * cell;
            double z = (middleZ + i) * cell;
            DisplayColour alongZ = floorColour(middleX + i, background.shade(MarkColour.AXIS_Z));
            DisplayColour alongX = floorColour(middleZ + i, background.shade(MarkColour.AXIS_X));
            addFloorLine(new Vec3(x, 0, middleZ * cell), new Vec3(0, 0, reach), alongZ);
            addFloorLine(new Vec3(middleX * cell, 0, z), new Vec3(reach, 0, 0), alongX);
        }
    }

    private static DisplayColour floorColour(long line, DisplayColour axis) {
        if (line == 0) {
            return axis;
        }
        return FLOOR.withAlpha(Math.floorMod(line, FLOOR_CELLS_PER_MAJOR) == 0 ? FLOOR_MAJOR_ALPHA : FLOOR_MINOR_ALPHA);
    }

    private void addFloorLine(Vec3 middle, Vec3 half, DisplayColour colour) {
        ground.line(middle.minus(half), middle.plus(half), colour, 1, LineLayer.BEHIND_SURFACES);
    }
}
