package nephele.engine.render;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.scene.ViewNode;

/** Pictures of views through portals, for the texture technique; reused from frame to frame. */
final class PortalPictures implements AutoCloseable {
    private final GlContext gl;
    private final double resolution;
    private final List<RenderTarget> free = new ArrayList<>();
    private final List<RenderTarget> byNumber = new ArrayList<>();
    private PixelFormat format;
    private int width;
    private int height;

    /** @param resolution size as a share of the picture's sides */
    PortalPictures(GlContext gl, double resolution) {
        this.gl = gl;
        this.resolution = resolution;
    }

    /** Marks all pictures as free for a frame of this size. */
    void begin(PixelFormat newFormat, int pictureWidth, int pictureHeight) {
        for (int i = 0; i < byNumber.size(); i++) {
            release(i);
        }
        int newWidth = pixels(pictureWidth);
        int newHeight = pixels(pictureHeight);
        if (format != newFormat || width != newWidth || height != newHeight) {
            close();
            format = newFormat;
            width = newWidth;
            height = newHeight;
        }
    }

    private int pixels(int ofPicture) {
        return Math.max(1, (int) Math.round(resolution * ofPicture));
    }

    RenderTarget take(ViewNode node) {
        while (byNumber.size() <= node.number()) {
            byNumber.add(null);
        }
        RenderTarget target = free.isEmpty() ? newTarget() : free.remove(free.size() - 1);
        byNumber.set(node.number(), target);
        return target;
    }

    private RenderTarget newTarget() {
        // At full resolution texels coincide with pixels, and interpolation would add rounding errors.
        Sampling sampling = resolution == 1 ? Sampling.NEAREST_CLAMP : Sampling.LINEAR_CLAMP;
        return RenderTarget.picture(gl, "view through a portal", format, width, height, sampling);
    }

    RenderTarget of(ViewNode node) {
        return byNumber.get(node.number());
    }

    void release(ViewNode node) {
        release(node.number());
    }

    private void release(int number) {
        if (byNumber.get(number) != null) {
            free.add(byNumber.get(number));
            byNumber.set(number, null);
        }
    }

    @Override
    public void close() {
        free.forEach(RenderTarget::close);
        free.clear();
        for (RenderTarget target : byNumber) {
            if (target != null) {
                target.close();
            }
        }
        byNumber.clear();
    }
}
