package nephele.engine.render;

import java.util.List;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.Opening;
import nephele.engine.scene.ViewHistory;
import nephele.engine.scene.ViewTree;

/** The previous picture and its views; empty at first and after a cut. */
final class PreviousPicture implements AutoCloseable {
    private final GlContext gl;
    private final ViewHistory history = new ViewHistory();
    /** Two trees that alternate: one is built while the other one's views are looked up. */
    private ViewTree next;

    private ViewTree kept;
    private RenderTarget copy;

    PreviousPicture(GlContext gl, List<Opening> mirrors) {
        this.gl = gl;
        next = new ViewTree(mirrors);
        kept = new ViewTree(mirrors);
    }

    /** Returns the tree to build for the frame that begins. */
    ViewTree nextTree() {
        return next;
    }

    void match(ViewTree tree, int width, int height) {
        if (copy != null && (copy.width() != width || copy.height() != height)) {
            history.forget();
        }
        history.match(tree);
    }

    void remember(ViewTree tree, RenderTarget surface) {
        if (copy == null
                || copy.width() != surface.width()
                || copy.height() != surface.height()
                || copy.format() != surface.format()) {
            close();
            copy = RenderTarget.picture(
                    gl, "previous picture", surface.format(), surface.width(), surface.height(), Sampling.LINEAR_CLAMP);
        }
        surface.copyTo(copy);
        history.remember(tree);
        next = kept;
        kept = tree;
    }

    void forget() {
        history.forget();
    }

    ViewHistory history() {
        return history;
    }

    Texture picture() {
        return copy.colour();
    }

    @Override
    public void close() {
        if (copy != null) {
            copy.close();
            copy = null;
        }
    }
}
