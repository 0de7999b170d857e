package nephele.editor.window.viewport;

import com.formdev.flatlaf.util.UIScale;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import nephele.editor.draw.Background;
import nephele.editor.draw.BackgroundWork;
import nephele.editor.draw.LightProgress;
import nephele.editor.draw.PaneInset;
import nephele.editor.draw.PaneInset.LegendLine;
import nephele.editor.draw.PaneInset.Pattern;
import nephele.editor.draw.ViewportDrawing;
import nephele.editor.draw.ViewportFrame;
import nephele.editor.draw.ViewportFrame.Look;
import nephele.editor.draw.ViewportFrame.Pane;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneLayout.PaneRectangle;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.ViewMode;
import nephele.editor.proving.HeatOverlay;
import nephele.editor.proving.HeatText;
import nephele.editor.proving.ProvingText;
import nephele.editor.proving.TracedCorner.Traced;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.text.Words;
import nephele.editor.window.viewport.SessionMarks.Marked;
import nephele.editor.window.viewport.SurfacePainter.Painting;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Language;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;

/** Paints a session's frame on the surface. The session is read on its own thread only, before the frame is drawn. */
final class ViewportScene implements SurfacePainter {
    private static final Words DRAWING =
            Words.of("Drawing the level: %s s", "Desenhando a fase: %s s", "A desenhar o nível: %s s");

    private static final Words COARSE =
            Words.of("Light, coarse: %s %%", "Luz, aproximada: %s %%", "Luz, aproximada: %s %%");
    private static final Words FINE_SECONDS =
            Words.of("Light: %s %%, %s s left", "Luz: %s %%, faltam %s s", "Luz: %s %%, faltam %s s");
    private static final Words FINE_MINUTES =
            Words.of("Light: %s %%, %s min left", "Luz: %s %%, faltam %s min", "Luz: %s %%, faltam %s min");

    private final EditorSession session;
    private final BackgroundWork work;
    private final Consumer<String> report;
    private List<String> reported = List.of();
    private boolean isComplete;
    /** The files of the level whose pictures have begun; {@code null} before the first. */
    private AssetSource begun;

    // Used by the drawing thread alone.
    private final SessionMarks marks = new SessionMarks();
    private ViewportDrawing drawing;
    private long lastNanos;

    /** @param report receives what cannot be drawn, a line each */
    ViewportScene(EditorSession session, BackgroundWork work, Consumer<String> report) {
        this.session = session;
        this.work = work;
        this.report = report;
    }

    @Override
    public void opened(GlContext gl) {
        drawing = new ViewportDrawing(gl, work);
    }

    @Override
    public Painting next(SurfaceSize size) {
        session.viewport(new PaneSize(size.width(), size.height()));
        ViewportFrame frame = frame(pixelsPerPoint(size));
        session.maps().drawing(frame.level());
        Marked marked = Marked.of(session);
        boolean isAtOnce = isComplete;
        boolean isFirst = !isAtOnce && begun != session.assets();
        begun = session.assets();
        if (isFirst) {
            // Edges are there long before tables and shaders are.
            work.repaintSoon().run();
            return target -> draw(frame.with(marks.of(marked)).withEdgesOnly(), target, true);
        }
        return target -> draw(frame.with(marks.of(marked)), target, isAtOnce);
    }

    private Runnable draw(ViewportFrame frame, RenderTarget target, boolean isAtOnce) {
        drawing.draw(frame, target, isAtOnce ? Double.POSITIVE_INFINITY : elapsedSeconds());
        if (drawing.isChanging()) {
            work.repaintSoon().run();
        }
        List<String> messages = List.copyOf(drawing.messages());
        boolean isLightKnown = drawing.isLightKnown();
        Words bake = words(drawing.lightProgress());
        return () -> {
            reportNew(messages);
            session.bake(bake);
            if (isLightKnown && session.assets() == frame.assets()) {
                session.foundBakedLight();
            }
        };
    }

    private static Words words(LightProgress bake) {
        double minutes = bake.secondsLeft() / 60;
        int percent = (int) (100 * bake.fraction());
        return switch (bake.stage()) {
            case NONE -> Words.NONE;
            case COARSE -> COARSE.with(percent);
            case FINE ->
                minutes < 1.5
                        ? FINE_SECONDS.with(percent, (int) bake.secondsLeft())
                        : FINE_MINUTES.with(percent, Math.round(minutes));
        };
    }

    private void reportNew(List<String> messages) {
        if (!messages.equals(reported)) {
            reported = messages;
            reported.forEach(report);
        }
    }

    /** Paints with all edits taken over until this returns, as for a picture that is kept. */
    <T> T complete(Supplier<T> painting) {
        isComplete = true;
        try {
            return painting.get();
        } finally {
            isComplete = false;
        }
    }

    /** Returns the time since the last frame if that was part of a change: before it the display may have stood still. */
    private double elapsedSeconds() {
        long now = System.nanoTime();
        double seconds = drawing.isChanging() ? (now - lastNanos) * 1e-9 : 0;
        lastNanos = now;
        return seconds;
    }

    /** Returns the display's scale times that of the user's interface. */
    static double pixelsPerPoint(SurfaceSize size) {
        return size.pixelsPerPoint() * UIScale.getUserScaleFactor();
    }

    /** Returns the gap between panes in pixels. */
    static int gap(Supplier<SurfaceSize> size) {
        return (int) Math.round(PaneLayout.GAP_PIXELS * pixelsPerPoint(size.get()));
    }

    private ViewportFrame frame(double scale) {
        PaneLayout layout = session.panes();
        int gap = (int) Math.round(PaneLayout.GAP_PIXELS * scale);
        List<Pane> panes = layout.rectangles(session.viewport(), gap).stream()
                .map(this::pane)
                .toList();
        int active = 0;
        for (int i = 0; i < panes.size(); i++) {
            active = panes.get(i).place().index() == layout.active() ? i : active;
        }
        boolean isDark = session.settings().get(EditorSetting.THEME) == Theme.DARK;
        Look look = new Look(
                isDark ? Background.DARK : Background.LIGHT,
                session.grid().stepMetres(),
                session.settings().get(EditorSetting.GUIDE_LINES),
                scale);
        return new ViewportFrame(
                session.document().level(),
                session.assets(),
                panes,
                active,
                List.of(),
                look,
                !session.document().isDragging(),
                session.bakesLight());
    }

    private Pane pane(PaneRectangle place) {
        PaneView view = session.panes().views().get(place.index());
        return new Pane(place, view, of(view).in(session.language()), marks(session, view), of(session, place));
    }

    @Override
    public void closing() {
        if (drawing != null) {
            drawing.close();
            drawing = null;
        }
    }

    @Override
    public void failed(String reason) {
        report.accept(reason);
    }

    @Override
    public String waiting(int seconds) {
        return DRAWING.with(seconds).in(session.language());
    }

    private static Words of(PaneView view) {
        return view.kind() == PaneKind.PERSPECTIVE ? of(view.mode()) : of(view.kind());
    }

    private static Words of(PaneKind kind) {
        return switch (kind) {
            case PERSPECTIVE -> Words.of("Perspective", "Perspectiva", "Perspetiva");
            case TOP -> Words.of("Top", "Topo", "Topo");
            case FRONT -> Words.of("Front", "Frente", "Frente");
            case SIDE -> Words.of("Side", "Lado", "Lado");
        };
    }

    private static Words of(ViewMode mode) {
        return switch (mode) {
            case LIT -> Words.of("Perspective, lit", "Perspectiva, iluminada", "Perspetiva, iluminada");
            case UNLIT -> Words.of("Perspective, unlit", "Perspectiva, sem luz", "Perspetiva, sem luz");
            case PORTALABLE -> Words.of("Perspective, portalable", "Perspectiva, portais", "Perspetiva, portais");
            case COLLISION -> Words.of("Perspective, collision", "Perspectiva, colisão", "Perspetiva, colisão");
            case WIREFRAME -> Words.of("Perspective, edges", "Perspectiva, arestas", "Perspetiva, arestas");
        };
    }

    private static List<Mark> marks(EditorSession session, PaneView view) {
        return view.kind() == PaneKind.PERSPECTIVE ? session.proving().heat().marks() : List.of();
    }

    private static PaneInset of(EditorSession session, PaneRectangle place) {
        PaneView view = session.panes().views().get(place.index());
        if (view.kind() != PaneKind.PERSPECTIVE) {
            return PaneInset.NONE;
        }
        Language language = session.language();
        Traced traced = session.proving().corner().traced(place.index()).orElse(null);
        String caption = traced == null
                ? ""
                : traced.samples() == 0
                        ? ProvingText.TRACING.in(language)
                        : ProvingText.TRACED.with(traced.samples()).in(language);
        return new PaneInset(
                legend(session.proving().heat(), language), traced == null ? null : traced.picture(), caption);
    }

    private static List<LegendLine> legend(HeatOverlay heat, Language language) {
        if (!heat.isVisible()) {
            return List.of();
        }
        List<LegendLine> lines = new ArrayList<>();
        heat.counts().forEach((text, count) -> lines.add(line(text, count, language)));
        return lines;
    }

    private static LegendLine line(HeatText text, int count, Language language) {
        String words = count + "  " + text.legend().in(language);
        return switch (text) {
            case FITS -> new LegendLine(MarkColour.ALLOWED, Pattern.PLAIN, words);
            case SLIDES -> new LegendLine(MarkColour.SLIDES, Pattern.SLANTED, words);
            case NOTHING_HIT,
                    OUT_OF_RANGE,
                    MOVING_SURFACE,
                    NOT_PORTALABLE,
                    NOT_FLAT,
                    OVERLAPS_OTHER,
                    TOO_SMALL,
                    EDGE,
                    OCCUPIED -> new LegendLine(MarkColour.REFUSED, Pattern.CROSSED, words);
        };
    }
}
