package nephele.app.play;

import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.host.compare.Wipe;

/**
 * The level behind the title, drawn once for each size of the window and then kept: menus answer at once, also where a
 * frame of the level takes long. It is drawn in steps, and only while the player rests.
 */
final class TitlePicture implements AutoCloseable {
    /** The frames among which clouds divide their rays. */
    private static final int FRAMES_WITH_CLOUDS = 4;

    /** The size of a first frame that only compiles programs, as part of the picture's. */
    private static final int FIRST_STEP_PART = 8;

    private final GlContext gl;
    /** {@code null} before the first picture, which has its size until another one is drawn. */
    private RenderTarget kept;
    /** Compared by identity: another one draws anew. */
    private SessionPicture drawer;

    private int width;
    private int height;
    private boolean isCompiled;
    private int framesLeft;

    TitlePicture(GlContext gl) {
        this.gl = gl;
    }

    /**
     * Fills the target with the title's view of a level; returns false if there is no picture of it yet.
     *
     * @param mayWork whether a step may be drawn, which takes a while
     */
    boolean draw(Session session, double aspect, RenderTarget target, boolean mayWork) {
        boolean isNew = drawer != session.picture(); // has just been loaded, which is a step
        if (isNew) {
            drawer = session.picture();
            isCompiled = false;
            begin(session, target);
        } else if (width != target.width() || height != target.height()) {
            begin(session, target);
        }
        if (framesLeft > 0 && mayWork && !isNew) {
            if (isCompiled) {
                drawFrame(session, aspect);
            } else {
                compile(session, aspect);
            }
        }
        if (kept == null) {
            return false;
        }
        kept.copyScaledTo(target);
        return true;
    }

    private void begin(Session session, RenderTarget target) {
        width = target.width();
        height = target.height();
        framesLeft = session.level().environment().clouds().isEmpty() ? 1 : FRAMES_WITH_CLOUDS;
    }

    private void compile(Session session, double aspect) {
        isCompiled = true;
        int smallWidth = Math.max(1, width / FIRST_STEP_PART);
        int smallHeight = Math.max(1, height / FIRST_STEP_PART);
        try (var small = RenderTarget.picture(gl, "title", PixelFormat.RGBA8, smallWidth, smallHeight)) {
            draw(session, aspect, small);
        }
        drawer.forget();
    }

    private void drawFrame(Session session, double aspect) {
        framesLeft--;
        if (kept == null || kept.width() != width || kept.height() != height) {
            close();
            kept = RenderTarget.picture(gl, "title", PixelFormat.RGBA8, width, height);
        }
        draw(session, aspect, kept);
    }

    private void draw(Session session, double aspect, RenderTarget picture) {
        drawer.draw(session.titleView(aspect, 0), session.titleState(), Wipe.MIDDLE, picture, StepListener.NONE);
    }

    @Override
    public void close() {
        if (kept != null) {
            kept.close();
            kept = null;
        }
    }
}
