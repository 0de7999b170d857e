package nephele.app.play;

import nephele.engine.compare.Wipe;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;

/**
 * The level behind the title, drawn once for each size of the window and then kept: menus answer at once, also where a
 * frame of the level takes long.
 */
final class TitlePicture implements AutoCloseable {
    /** The frames among which clouds divide their rays. */
    private static final int FRAMES_WITH_CLOUDS = 4;

    private final GlContext gl;
    private RenderTarget kept;
    /** Compared by identity: another one draws anew. */
    private SessionPicture drawer;

    private int framesLeft;

    TitlePicture(GlContext gl) {
        this.gl = gl;
    }

    /** Fills the target with the title's view of a level. */
    void draw(Session session, double aspect, RenderTarget target) {
        boolean fits = kept != null && kept.width() == target.width() && kept.height() == target.height();
        if (!fits) {
            close();
            kept = RenderTarget.picture(gl, "title", PixelFormat.RGBA8, target.width(), target.height());
        }
        if (!fits || drawer != session.picture()) {
            drawer = session.picture();
            framesLeft = session.level().environment().clouds().isEmpty() ? 1 : FRAMES_WITH_CLOUDS;
        }
        if (framesLeft > 0) {
            framesLeft--;
            drawer.draw(session.titleView(aspect, 0), session.titleState(), Wipe.MIDDLE, kept, StepListener.NONE);
        }
        kept.copyScaledTo(target);
    }

    @Override
    public void close() {
        if (kept != null) {
            kept.close();
            kept = null;
        }
    }
}
