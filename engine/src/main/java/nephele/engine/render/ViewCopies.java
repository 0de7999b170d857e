package nephele.engine.render;

import java.util.Map;
import java.util.Set;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.CopiedPlanes;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Texture;

/**
 * Copies of a view's depth and colours for the passes after its opaque surfaces. All views of one size share a copy in
 * turn, since a view is drawn completely before its parent continues. If no pass reads copies, none is made.
 */
final class ViewCopies implements AutoCloseable {
    private final GlContext gl;
    private final Map<Target, Texture> targets;
    private final Set<Target> read;
    private RenderTarget copy;
    /** True from the first view on whose colours were read: before that, there is no memory for them. */
    private boolean hasColour;

    /**
     * @param targets receives the copies
     * @param read targets that passes read; only {@link Target#VIEW_DEPTH} and {@link Target#VIEW_COLOUR} matter
     */
    ViewCopies(GlContext gl, Map<Target, Texture> targets, Set<Target> read) {
        this.gl = gl;
        this.targets = targets;
        this.read = read;
    }

    /** Returns true if a pass reads copies. */
    static boolean isRead(Set<Target> read) {
        return read.contains(Target.VIEW_DEPTH) || read.contains(Target.VIEW_COLOUR);
    }

    /** Returns true if there is anything to copy. */
    boolean areRead() {
        return isRead(read);
    }

    /** Returns such copies for views of another size. */
    ViewCopies another() {
        return new ViewCopies(gl, targets, read);
    }

    /** Copies these planes of {@code surface} within the scissor and passes them to the passes. */
    void take(RenderTarget surface, CopiedPlanes planes) {
        hasColour |= planes != CopiedPlanes.DEPTH;
        fit(surface);
        surface.copyTo(copy, planes);
        targets.put(Target.VIEW_DEPTH, copy.depth());
        if (hasColour) {
            targets.put(Target.VIEW_COLOUR, copy.colour());
        }
    }

    private void fit(RenderTarget surface) {
        PixelFormat format = hasColour ? surface.format() : null;
        if (copy == null
                || copy.width() != surface.width()
                || copy.height() != surface.height()
                || copy.format() != format) {
            close();
            copy = RenderTarget.readable(gl, "copy of a view", format, surface.width(), surface.height());
        }
    }

    @Override
    public void close() {
        if (copy != null) {
            copy.close();
            copy = null;
        }
    }
}
