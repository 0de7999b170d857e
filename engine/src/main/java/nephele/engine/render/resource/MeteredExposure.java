package nephele.engine.render.resource;

import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.FrameState;

/**
 * The exposure of a renderer's pictures that follows from them: the history of a view, which stays on the GPU. It is one
 * texel: the factor on radiance and its log2, which adapts in simulated time. Without history, at first and after a cut,
 * it is metered from the picture alone.
 */
public final class MeteredExposure implements GlObject {
    public static final SharedResource<MeteredExposure> RESOURCE = SharedResource.of("exposure", MeteredExposure::of);

    private static final String NAME = "metered exposure";

    private final RenderTarget[] texels = new RenderTarget[2];
    private int last;
    private boolean hasHistory;
    private double lastSeconds;
    private int width;
    private int height;
    private double elapsedSeconds;
    private boolean isReadInViews;

    MeteredExposure(GlContext gl) {
        for (int i = 0; i < texels.length; i++) {
            texels[i] = RenderTarget.picture(gl, NAME, PixelFormat.RGBA32F, 1, 1);
        }
    }

    /** Returns {@code null} if exposure is not metered. */
    private static MeteredExposure of(LoadContext context) {
        return context.request().metersExposure() ? context.own(new MeteredExposure(context.gl())) : null;
    }

    /**
     * Notes that a program draws values of the display in a view, see {@code exposure.glsl}; does nothing if no exposure is
     * metered. It reads the exposure of the last picture, so a picture without history has to be metered before.
     */
    public static void readInViews(LoadContext context) {
        if (context.request().metersExposure()) {
            context.get(RESOURCE).isReadInViews = true;
        }
    }

    /** Returns the blending of display values over a view: they take no part in the metering. */
    public static Blend over(LoadContext context) {
        return context.request().metersExposure() ? Blend.OVER_UNMETERED : Blend.OVER;
    }

    /** Returns the blending that adds display values to a view. */
    public static Blend added(LoadContext context) {
        return context.request().metersExposure() ? Blend.ADD_UNMETERED : Blend.ADD;
    }

    /**
     * Begins a frame: binds the exposure of the last picture. After a jump back in time and in a picture of another size
     * there is no history.
     */
    public void begin(FrameState frameState, RenderTarget picture) {
        double seconds = frameState.seconds();
        hasHistory &= seconds >= lastSeconds && width == picture.width() && height == picture.height();
        width = picture.width();
        height = picture.height();
        elapsedSeconds = hasHistory ? seconds - lastSeconds : 0;
        lastSeconds = seconds;
        if (!hasHistory) {
            texels[last].clear(1, 0, 0);
        }
        bind();
    }

    /** Returns true if the frame that begins must be drawn once to meter it and once to show it. */
    public boolean needsDrawingBefore() {
        return isReadInViews && !hasHistory;
    }

    /** Returns true if there is an exposure to adapt from. */
    public boolean hasHistory() {
        return hasHistory;
    }

    /** Returns the simulated time since the last picture. */
    public double elapsedSeconds() {
        return elapsedSeconds;
    }

    /** Returns the texel to write: factor, stops, the stops that are metered from the picture. */
    public RenderTarget next() {
        return texels[1 - last];
    }

    /** Takes the written texel as this picture's, and binds it. */
    public void advance() {
        last = 1 - last;
        hasHistory = true;
        elapsedSeconds = 0;
        bind();
    }

    private void bind() {
        texels[last].colour().bind(TextureUnit.EXPOSURE);
    }

    /** Drops the history. */
    public void forget() {
        hasHistory = false;
    }

    /** Continues the adaption of another renderer of the context, whose pictures have the same size. */
    public void follow(MeteredExposure other) {
        if (other.hasHistory) {
            other.texels[other.last].copyTo(texels[last]);
            hasHistory = true;
            lastSeconds = other.lastSeconds;
            width = other.width;
            height = other.height;
        }
    }

    /** Returns the stops of the last picture; waits for the GPU, for tests and figures. */
    public double readStops() {
        return texels[last].readFloats()[1];
    }

    @Override
    public void close() {
        for (RenderTarget texel : texels) {
            texel.close();
        }
    }
}
