package nephele.editor.draw;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.draw.MarkDrawing.Outline;
import nephele.editor.draw.ViewportFrame.GuideLines;
import nephele.editor.draw.ViewportFrame.Pane;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.line.LineCanvas;
import nephele.engine.render.line.LineColour;
import nephele.engine.render.line.LineDrawing;
import nephele.engine.render.line.LineLayer;
import nephele.engine.render.line.LineProjection;
import nephele.engine.render.pass.overlay.Lettering;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.engine.render.pass.overlay.OverlayColour;
import nephele.engine.render.pass.overlay.OverlayPass;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;

/** Draws one pane after another: what the level shows, then marks and letters over it. */
final class PaneDrawing implements AutoCloseable {
    private static final double NEAR_METRES = 0.05;
    private static final double CAPTION_BASELINE_POINTS = 34;
    private static final LineColour CAPTION = LineColour.of(0xe6eaee, 1);
    private static final double AXES_CORNER_POINTS = 34;
    private static final double AXIS_POINTS = 22;
    private static final double AXIS_LETTER_POINTS = 11;
    /** Axes that point to or from the eye have no letter. */
    private static final double LEAST_AXIS_ACROSS = 0.15;

    private final LineDrawing drawing;
    private final OverlayPass overlay;
    private final LineCanvas ground = new LineCanvas();
    private final GroundLines terrains = new GroundLines();
    private final LineCanvas lines = new LineCanvas();
    private final OverlayCanvas texts;

    PaneDrawing(GlContext gl) {
        Lettering lettering = new Lettering();
        drawing = new LineDrawing(gl);
        overlay = new OverlayPass(gl, lettering);
        texts = new OverlayCanvas(lettering);
    }

    /** The level's picture in a pane. */
    sealed interface Shown {
        /** Surfaces in a view mode. */
        record Surfaces(LevelPicture picture) implements Shown {}

        /** Surfaces, and the edges between them in a colour. */
        record EdgedSurfaces(LevelPicture picture, LevelEdges edges, LineColour colour) implements Shown {}

        /** Edges alone, in a plan with the lines of terrains. */
        record Edges(LevelEdges edges, List<HeightField> ground) implements Shown {}
    }

    /** Draws over the whole picture. */
    void draw(Shown shown, Pane pane, ViewportFrame frame, RenderTarget picture) {
        PaneCamera camera = pane.view().camera();
        PaneSize size = new PaneSize(picture.width(), picture.height());
        boolean isPlain = shown instanceof Shown.Edges && frame.look().background() == Background.LIGHT;
        MarkPalette palette = isPlain ? MarkPalette.ON_LIGHT : MarkPalette.ON_DARK;
        texts.begin(frame.look().pixelsPerPoint());
        LineProjection projection = camera instanceof PlanCamera plan
                ? plan(shown, plan, frame, picture, palette)
                : perspective(shown, (PerspectiveCamera) camera, frame, picture, palette);
        lines.begin(projection);
        MarkDrawing marks = new MarkDrawing(lines, texts, palette, frame.look().pixelsPerPoint());
        List<Mark> all = new ArrayList<>(frame.marks());
        all.addAll(pane.marks());
        marks.add(all, camera, size, shown instanceof Shown.Edges ? Outline.NONE : Outline.DARK);
        addAxes(lines, texts, camera, size, marks);
        if (!pane.caption().isEmpty()) {
            marks.plate(pane.caption(), 10, CAPTION_BASELINE_POINTS, CAPTION);
        }
        new InsetDrawing(texts, frame.look().pixelsPerPoint()).add(pane.inset(), picture.width(), picture.height());
        drawing.draw(lines, picture);
        overlay.draw(texts, picture);
    }

    private LineProjection perspective(
            Shown shown, PerspectiveCamera camera, ViewportFrame frame, RenderTarget picture, MarkPalette palette) {
        View view = view(camera, picture.width() / (double) picture.height());
        LineProjection projection = LineProjection.of(view, picture.width(), picture.height());
        if (shown instanceof Shown.Surfaces surfaces) {
            surfaces.picture().draw(view, picture);
        } else if (shown instanceof Shown.EdgedSurfaces surfaces) {
            surfaces.picture().draw(view, picture);
            surfaces.edges().draw(projection, surfaces.colour(), LineLayer.BEHIND_SURFACES, picture);
        } else {
            clear(picture, frame.look().background().rgb());
        }
        ground.begin(projection);
        if (frame.look().guideLines() == GuideLines.SHOWN) {
            new FloorLines(camera.eye(), frame.look().gridMetres(), palette).add(ground);
        }
        drawing.draw(ground, picture);
        edges(shown, projection, palette, picture);
        return projection;
    }

    /** Returns the engine's view of a camera. */
    static View view(PerspectiveCamera camera, double aspect) {
        Projection projection = new Projection(
                Math.toRadians(camera.verticalFovDegrees()), aspect, NEAR_METRES, Double.POSITIVE_INFINITY);
        return new View(
                camera.eye(), camera.right(), camera.up(), camera.forward().negated(), projection);
    }

    private LineProjection plan(
            Shown shown, PlanCamera camera, ViewportFrame frame, RenderTarget picture, MarkPalette palette) {
        int width = picture.width();
        int height = picture.height();
        double scale = frame.look().pixelsPerPoint();
        Basis axes = new Basis(camera.right(), camera.up(), camera.forward().negated());
        LineProjection projection =
                LineProjection.orthographic(camera.centre(), axes, camera.metresPerPixel(), width, height);
        GridSpacing spacing = GridSpacing.of(frame.look().gridMetres(), camera.metresPerPixel(), scale);
        PlanGrid grid = new PlanGrid(camera, new PaneSize(width, height), spacing, palette, scale);
        clear(picture, frame.look().background().rgb());
        ground.begin(projection);
        grid.addLines(ground);
        if (shown instanceof Shown.Edges edges) {
            terrains.add(edges.ground(), camera, new PaneSize(width, height), palette, ground);
        }
        drawing.draw(ground, picture);
        edges(shown, projection, palette, picture);
        if (shown instanceof Shown.Edges edges) {
            terrains.addLabels(edges.ground(), camera, new PaneSize(width, height), palette, scale, texts);
        }
        grid.addLabels(texts);
        return projection;
    }

    private static void edges(Shown shown, LineProjection projection, MarkPalette palette, RenderTarget picture) {
        if (shown instanceof Shown.Edges edges) {
            edges.edges().draw(projection, palette.of(MarkColour.EDGE), LineLayer.OVER_ALL, picture);
        }
    }

    static void clear(RenderTarget picture, int rgb) {
        picture.clear((rgb >> 16 & 255) / 255f, (rgb >> 8 & 255) / 255f, (rgb & 255) / 255f);
    }

    @Override
    public void close() {
        drawing.close();
        overlay.close();
    }

    /** Draws the directions of the axes of the world in the lower left corner of the pane. */
    private static void addAxes(
            LineCanvas lines, OverlayCanvas texts, PaneCamera camera, PaneSize size, MarkDrawing with) {
        axis(lines, texts, new DrawnAxis(camera, new Vec3(1, 0, 0), size, with), MarkColour.AXIS_X, "x");
        axis(lines, texts, new DrawnAxis(camera, new Vec3(0, 1, 0), size, with), MarkColour.AXIS_Y, "y");
        axis(lines, texts, new DrawnAxis(camera, new Vec3(0, 0, 1), size, with), MarkColour.AXIS_Z, "z");
    }

    private record DrawnAxis(PaneCamera camera, Vec3 axis, PaneSize size, MarkDrawing with) {
        double[] at(double points) {
            double scale = with.pixelsPerPoint();
            double x = AXES_CORNER_POINTS + points * axis.dot(camera.right());
            double y = -AXES_CORNER_POINTS - points * axis.dot(camera.up());
            return new double[] {scale * x, size.height() + scale * y};
        }

        boolean isVisible() {
            return Math.hypot(axis.dot(camera.right()), axis.dot(camera.up())) > LEAST_AXIS_ACROSS;
        }
    }

    private static void axis(LineCanvas lines, OverlayCanvas texts, DrawnAxis along, MarkColour colour, String name) {
        if (!along.isVisible()) {
            return;
        }
        double scale = along.with().pixelsPerPoint();
        LineColour shade = along.with().palette().of(colour);
        if (along.with().palette() == MarkPalette.ON_DARK) {
            lines.screenLine(along.at(0), along.at(AXIS_POINTS), LineColour.of(0, 0.5), 4 * scale);
        }
        lines.screenLine(along.at(0), along.at(AXIS_POINTS), shade, 2 * scale);
        double[] end = along.at(AXIS_POINTS + 8);
        if (along.with().palette() == MarkPalette.ON_DARK) {
            OverlayColour shadow = new OverlayColour(0, 0, 0, 0.7f);
            texts.text(end[0] / scale - 2, end[1] / scale + 5, AXIS_LETTER_POINTS, shadow, name);
        }
        texts.text(end[0] / scale - 3, end[1] / scale + 4, AXIS_LETTER_POINTS, MarkDrawing.overlay(shade), name);
    }

    /** The grid on the plane y = 0 around the eye of a perspective pane. */
    private record FloorLines(Vec3 eye, double gridMetres, MarkPalette palette) {
        private static final int CELLS = 24;
        private static final int CELLS_PER_MAJOR = 8;
        private static final double MINOR_ALPHA = 0.28;
        private static final double MAJOR_ALPHA = 0.5;

        /** Adds the lines; their spacing grows with the eye's height. */
        void add(LineCanvas lines) {
            double least = Math.max(gridMetres, Math.abs(eye.y()) / CELLS);
            double cell = gridMetres * Math.pow(2, Math.ceil(Math.log(least / gridMetres) / Math.log(2)));
            cell = Math.max(cell, gridMetres * Math.pow(2, Math.ceil(Math.log(0.5 / gridMetres) / Math.log(2))));
            long middleX = Math.round(eye.x() / cell);
            long middleZ = Math.round(eye.z() / cell);
            double reach = 2.0 * CELLS * cell;
            LineColour grey = LineColour.of(0x8a949e, 1);
            for (long i = -2 * CELLS; i <= 2 * CELLS; i++) {
                double x = (middleX + i) * cell;
                double z = (middleZ + i) * cell;
                addLine(lines, new Vec3(x, 0, middleZ * cell), new Vec3(0, 0, reach), colour(middleX + i, grey, true));
                addLine(lines, new Vec3(middleX * cell, 0, z), new Vec3(reach, 0, 0), colour(middleZ + i, grey, false));
            }
        }

        private LineColour colour(long line, LineColour grey, boolean isAlongZ) {
            if (line == 0) {
                return palette.of(isAlongZ ? MarkColour.AXIS_Z : MarkColour.AXIS_X);
            }
            return grey.withAlpha(Math.floorMod(line, CELLS_PER_MAJOR) == 0 ? MAJOR_ALPHA : MINOR_ALPHA);
        }

        private static void addLine(LineCanvas lines, Vec3 middle, Vec3 half, LineColour colour) {
            lines.line(middle.minus(half), middle.plus(half), colour, 1, LineLayer.BEHIND_SURFACES);
        }
    }
}
