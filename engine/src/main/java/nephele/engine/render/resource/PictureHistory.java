package nephele.engine.render.resource;

import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Reprojection;
import nephele.engine.scene.View;

/**
 * The course of the frames that are averaged: which points of its pixels the frame sees, and where it shows what the frame
 * before has shown.
 */
public final class PictureHistory {
    /** {@code null} if frames are not averaged. */
    public static final SharedResource<PictureHistory> RESOURCE =
            SharedResource.of("picture history", PictureHistory::of);

    /** The number of points of a pixel that successive frames see; afterwards they are the same again. */
    public static final int POINTS = 8;

    /** From point to point: they are those of a lattice, far from those just before, and the first is the pixel's centre. */
    private static final int STEP = 3;

    private static final int SLOPE = 3;

    private final Reprojection reprojection = new Reprojection();
    private boolean isEmpty = true;
    private int frame;
    private int framesAtRest;
    private int width;
    private int height;

    private PictureHistory() {}

    private static PictureHistory of(LoadContext context) {
        return context.request().isAccumulated() ? new PictureHistory() : null;
    }

    /**
     * Begins a frame.
     *
     * @param before the view of the frame before, on this side of portals; {@code null} without one
     * @param drawn the picture of the views
     */
    public void begin(View before, View now, RenderTarget drawn) {
        isEmpty |= before == null || width != drawn.width() || height != drawn.height();
        width = drawn.width();
        height = drawn.height();
        frame = isEmpty ? 0 : frame + 1;
        framesAtRest = !isEmpty && before.isSameAs(now) ? framesAtRest + 1 : 0;
        if (!isEmpty) {
            reprojection.between(now, before);
        }
        isEmpty = false;
    }

    /** Drops the frames so far: the next one has nothing to do with them. */
    public void forget() {
        isEmpty = true;
    }

    /** Returns true for a frame without one before. */
    public boolean isFirst() {
        return frame == 0;
    }

    /** Returns the number of frames since the view last changed. */
    public int framesAtRest() {
        return framesAtRest;
    }

    /** Maps places of this frame to those of the frame before; not if this is the first one. */
    public Reprojection reprojection() {
        return reprojection;
    }

    /** Returns the shift of the picture to the right in drawn pixels. */
    public double acrossPixels() {
        return centred(frame * STEP);
    }

    /** Returns the shift of the picture upwards in drawn pixels. */
    public double upPixels() {
        return centred(frame * STEP * SLOPE);
    }

    private static double centred(int eighths) {
        return (eighths + POINTS / 2) % POINTS / (double) POINTS - 0.5;
    }

    /** Returns the shift to the right in halves of the picture's width. */
    public double acrossShift() {
        return 2 * acrossPixels() / width;
    }

    /** Returns the shift upwards in halves of the picture's height. */
    public double upShift() {
        return 2 * upPixels() / height;
    }
}
