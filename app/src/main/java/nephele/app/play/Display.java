package nephele.app.play;

import java.io.IOException;
import java.util.List;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.Hud;
import nephele.app.play.hud.HudContent;
import nephele.app.settings.Phrase;
import nephele.app.window.GameWindow;
import nephele.app.window.Screenshots;
import nephele.engine.math.Vec3;
import nephele.engine.render.Renderer.StepListener;
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
import nephele.engine.render.timing.FrameCost;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import nephele.host.compare.Wipe;
import nephele.host.playthrough.ObserverView;
import nephele.host.playthrough.Rehearsal;

/** Draws frames into a window: the level, then the overlay; takes screenshots in between. */
final class Display implements AutoCloseable {
    /** The screenshot to take of the next frame. */
    enum Shot {
        NONE,
        WITH_OVERLAY,
        WITHOUT_OVERLAY
    }

    /** The colour behind the overlay while there is no level, linear or sRGB as the window takes it. */
    private static final float EMPTY_RED = 0.055f;

    private static final float EMPTY_GREEN = 0.09f;
    private static final float EMPTY_BLUE = 0.14f;

    private static final DisplayColour BLACK = DisplayColour.opaque(0);

    private static final DisplayColour OUTLINE = DisplayColour.of(0xFFD24A, 0.8);
    private static final double OUTLINE_PIXELS = 1.5;
    /** Frames of the first view that only compile programs. */
    private static final int FIRST_VIEW_WARM_UP = 2;

    private static final int FIRST_VIEW_FRAMES = 6;
    private static final long FIRST_VIEW_NANOS = 300_000_000L;

    private final GameWindow window;
    private final GlContext gl;
    private final FontAtlas letters = new FontAtlas();
    private final OverlayPass overlay;
    private final LineCanvas outlines = new LineCanvas();
    /** {@code null} before there is an observer. */
    private LineDrawing lines;

    private final Hud hud = new Hud(letters);
    private final OverlayCanvas veil = new OverlayCanvas(letters);
    private final Screenshots screenshots;
    private final Message message;
    private final FrameCost cost;
    private final TitlePicture title;
    private RenderTarget target;
    private Area area;
    /** The picture that was rehearsed last, compared by identity. */
    private SessionPicture rehearsed;

    /** @param message shows the files of screenshots */
    Display(GameWindow window, GlContext gl, Screenshots screenshots, Message message) {
        this.window = window;
        this.gl = gl;
        this.screenshots = screenshots;
        this.message = message;
        overlay = new OverlayPass(gl, letters);
        cost = new FrameCost(gl);
        title = new TitlePicture(gl);
    }

    /** Draws the overlay over an empty picture: there is no level yet. */
    void drawEmpty(HudContent content, Shot shot) {
        var picture = target();
        picture.bind();
        picture.clear(EMPTY_RED, EMPTY_GREEN, EMPTY_BLUE);
        drawOverlay(content, picture, shot);
        window.show();
    }

    /** Draws one frame of the game. */
    void draw(Session session, HudContent content, StepListener listener, Shot shot) {
        draw(session, session.walk().view(aspect()), session.walk().frameState(), content, listener, shot);
    }

    /** Draws one frame of the title over its level, which moves slowly. */
    void drawTitle(Session session, double seconds, HudContent content, StepListener listener, Shot shot) {
        draw(session, session.titleView(aspect(), seconds), session.titleState(), content, listener, shot);
    }

    private void draw(
            Session session, View view, FrameState state, HudContent content, StepListener listener, Shot shot) {
        var picture = target();
        var walk = session.walk();
        if (walk.takeCut()) {
            session.picture().forget();
        }
        cost.begins(listener != StepListener.NONE);
        Wipe wipe = content.comparison() == null
                ? Wipe.MIDDLE
                : content.comparison().wipe();
        session.picture().draw(view, state, wipe, picture, listener);
        drawOutlines(walk.observer(), view, picture);
        darken(walk.darkness(), picture);
        drawOverlay(content, picture, shot);
        cost.submitted();
        window.show();
        cost.presented();
    }

    /**
     * Draws the outlines of the bounds that an observer's sphere can touch.
     *
     * @param observer {@code null} for no outlines
     */
    private void drawOutlines(ObserverView observer, View view, RenderTarget picture) {
        if (observer == null) {
            return;
        }
        if (lines == null) {
            lines = new LineDrawing(gl);
        }
        outlines.begin(LineProjection.of(view, picture.width(), picture.height()));
        List<Vec3> ends = observer.outlines();
        for (int i = 0; i < ends.size(); i += 2) {
            outlines.line(ends.get(i), ends.get(i + 1), OUTLINE, OUTLINE_PIXELS, LineLayer.OVER_ALL);
        }
        lines.draw(outlines, picture);
    }

    /** Draws black over the level, but not over the overlay. */
    private void darken(double darkness, RenderTarget picture) {
        if (darkness > 0) {
            veil.begin(1);
            veil.rectangle(0, 0, picture.width(), picture.height(), BLACK.withAlpha(darkness));
            overlay.draw(veil, picture);
        }
    }

    /** Returns true if the level behind the title is kept: where a frame of it takes long. */
    boolean keepsTitle() {
        return gl.limits().software();
    }

    /**
     * Draws one frame of the title over its level, which stands still, or over nothing before it has been drawn.
     *
     * @param mayWork whether the level may be drawn, which takes a while
     */
    void drawTitle(Session session, HudContent content, Shot shot, boolean mayWork) {
        var picture = target();
        if (!title.draw(session, aspect(), picture, mayWork)) {
            picture.bind();
            picture.clear(EMPTY_RED, EMPTY_GREEN, EMPTY_BLUE);
        }
        drawOverlay(content, picture, shot);
        window.show();
    }

    /** Returns the time of the cheapest of a few frames of a level's first view, ms. None of them is shown. */
    double firstViewMillis(Session session) {
        var picture = target();
        View view = session.walk().view(aspect());
        double least = Double.POSITIVE_INFINITY;
        long begin = System.nanoTime();
        for (int frame = 0;
                frame <= FIRST_VIEW_WARM_UP
                        || frame < FIRST_VIEW_FRAMES && System.nanoTime() - begin < FIRST_VIEW_NANOS;
                frame++) {
            long start = System.nanoTime();
            session.picture().draw(view, session.walk().frameState(), Wipe.MIDDLE, picture, StepListener.NONE);
            gl.finish();
            if (frame >= FIRST_VIEW_WARM_UP) {
                least = Math.min(least, (System.nanoTime() - start) / 1e6);
            }
        }
        session.picture().forget();
        return least;
    }

    /**
     * Draws a frame of what shots bring into the level, and shows it to nobody, so that the first shot and the first view
     * through portals wait for no program. Does nothing if this picture has been rehearsed.
     */
    void rehearse(Session session) {
        if (rehearsed == session.picture()) {
            return;
        }
        rehearsed = session.picture();
        View view = session.walk().view(aspect());
        Rehearsal.of(session.level(), view, session.walk().frameState()).ifPresent(all -> {
            session.picture().draw(view, all, Wipe.MIDDLE, target(), StepListener.NONE);
            session.picture().forget();
            gl.finish();
        });
    }

    private void drawOverlay(HudContent content, RenderTarget picture, Shot shot) {
        if (shot == Shot.WITHOUT_OVERLAY) {
            save(picture);
        }
        overlay.draw(hud.canvas(content, area(), pixelsPerPoint()), picture);
        if (shot == Shot.WITH_OVERLAY) {
            save(picture);
        }
    }

    private void save(RenderTarget picture) {
        try {
            message.say(Phrase.SAVED, screenshots.take(picture));
        } catch (IOException failure) {
            message.say(Phrase.NOT_SAVED, failure.getMessage());
        }
    }

    /** Returns the time that the last frame of the game took, ms. */
    double costMillis() {
        return cost.millis();
    }

    /** Returns the number of the picture's pixels. */
    long pixels() {
        return (long) window.width() * window.height();
    }

    /** Returns width over height. */
    double aspect() {
        return (double) window.width() / window.height();
    }

    /** Returns the overlay's scale. */
    double pixelsPerPoint() {
        return Area.pixelsPerPoint(window.width(), window.height(), window.scale());
    }

    /** Returns the window's size in points. */
    Area area() {
        double width = window.width() / pixelsPerPoint();
        double height = window.height() / pixelsPerPoint();
        if (area == null || area.width() != width || area.height() != height) {
            area = new Area(width, height);
        }
        return area;
    }

    private RenderTarget target() {
        boolean fits = target != null && target.width() == window.width() && target.height() == window.height();
        if (!fits) {
            target = RenderTarget.window(gl, window.width(), window.height());
        }
        return target;
    }

    @Override
    public void close() {
        overlay.close();
        if (lines != null) {
            lines.close();
        }
        cost.close();
        title.close();
    }
}
