package nephele.engine.render.pass.cloud;

import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.View;

/**
 * The target of low resolution into which clouds are marched. The rays of one view can be divided among frames: a frame
 * marches one of each square of rays, and the others show what was seen in their direction before, at most as many
 * frames ago as a square has rays. The first frame after a cut marches all, as after a jump in time. Views that all march
 * all rays may share a layer in turn.
 */
final class CloudLayer implements GlObject, RayGrid {
    /** A longer time between two frames is a jump: clouds have another shape after it. */
    private static final double JUMP_SECONDS = 1;

    private final GlContext gl;
    private final LoadContext context;
    private final int divisor;
    private final int side;
    private final DrawState.Limits limits = new DrawState.Limits();
    private RenderTarget shown;
    /** The layer of the frame before, then that of the next; {@code null} without history, as are the following. */
    private RenderTarget other;

    private RenderTarget fresh;
    /** The layer as it is drawn; a pixel for each corner of its pixels. */
    private RenderTarget joined;

    private SpreadProgram program;
    private JoinProgram joining;
    private View before;
    private double seconds;
    private double secondsBefore;
    private int width;
    private int height;
    private int frame;
    private int cuts;

    /**
     * The cloud that may have moved farthest in a picture between two frames.
     *
     * @param metres from the eye to its bounds
     */
    record Nearest(PlacedCloud cloud, double metres) {
        private Vec3 blown(double secondsBefore, double seconds) {
            return cloud.source().drift(seconds).minus(cloud.source().drift(secondsBefore));
        }
    }

    /**
     * @param divisor pixels of the view along each side of one of the layer
     * @param side of the square of rays of which a frame marches one; 1 to march all
     */
    CloudLayer(LoadContext context, int divisor, int side) {
        this.context = context;
        gl = context.gl();
        this.divisor = divisor;
        this.side = side;
    }

    /**
     * Begins the layer of a view, empty.
     *
     * @param cutsSoFar number of cuts; the layer before is void if it has grown
     * @param now simulated seconds
     */
    void begin(RenderTarget surface, int cutsSoFar, double now) {
        if (shown == null || width != surface.width() || height != surface.height()) {
            resize(surface);
        }
        if (cuts != cutsSoFar || !(Math.abs(now - seconds) <= JUMP_SECONDS)) {
            before = null;
        }
        cuts = cutsSoFar;
        secondsBefore = before == null ? now : seconds;
        seconds = now;
        frame = before == null ? 0 : frame + 1;
        gl.state().beginLayer(divisor * marchedSide(), limits);
        (before == null ? shown : fresh).clearTransparentWithinScissor();
    }

    private void resize(RenderTarget surface) {
        close();
        width = surface.width();
        height = surface.height();
        shown = surface.reduced("clouds", PixelFormat.RGBA16F, divisor);
        joined = RenderTarget.picture(
                gl, "joined clouds", PixelFormat.RGBA16F, shown.width() + 1, shown.height() + 1, Sampling.LINEAR_CLAMP);
        if (side > 1) {
            other = surface.reduced("clouds before", PixelFormat.RGBA16F, divisor);
            int across = (shown.width() + side - 1) / side;
            int up = (shown.height() + side - 1) / side;
            fresh = RenderTarget.pair(gl, "marched clouds", PixelFormat.RGBA16F, across, up, Sampling.NEAREST_CLAMP);
        }
    }

    private int marchedSide() {
        return before == null ? 1 : side;
    }

    @Override
    public void put(PixelUniforms.Rays rays) {
        int n = marchedSide();
        double offset = 0.5 * (1 - n);
        double x = n == 1 ? 0 : column(frame, side);
        double y = n == 1 ? 0 : row(frame, side);
        rays.square().set(n, (float) (x + offset), (float) (y + offset));
        rays.step().set((float) (2.0 * divisor / width), (float) (2.0 * divisor / height));
    }

    @Override
    public double pixel() {
        return 2.0 * divisor * marchedSide() / height;
    }

    /** Returns the column of the ray that a frame marches in a square, whose side is a power of 2. */
    static int column(int frame, int side) {
        return side == 1 ? 0 : side / 2 * ((frame ^ frame >> 1) & 1) + column(frame >> 2, side / 2);
    }

    /** Returns the row; successive frames march rays that are far apart. */
    static int row(int frame, int side) {
        return side == 1 ? 0 : side / 2 * (frame & 1) + row(frame >> 2, side / 2);
    }

    /**
     * Ends the layer and restores the limits of the view.
     *
     * @param nearest that may be in the layer
     */
    void end(View view, Nearest nearest, FullScreenTriangle triangle) {
        if (before != null) {
            complete(view, nearest, triangle);
        }
        join(triangle);
        gl.state().endLayer(limits);
        before = side == 1 ? null : view;
    }

    @Override
    public double secondsBefore() {
        return secondsBefore;
    }

    private void complete(View view, Nearest nearest, FullScreenTriangle triangle) {
        if (program == null) {
            program = new SpreadProgram(context);
        }
        RenderTarget completed = other;
        other = shown;
        shown = completed;
        completed.bind();
        gl.state().set(DrawState.Depth.OFF, DrawState.Blend.REPLACE, DrawState.Cull.NONE);
        fresh.colour().bind(TextureUnit.SPREAD_FRESH);
        fresh.second().bind(TextureUnit.SPREAD_PLACES);
        other.colour().bind(TextureUnit.SPREAD_BEFORE);
        program.use(
                before,
                view,
                nearest.metres(),
                nearest.blown(secondsBefore, seconds),
                new SpreadProgram.Square(side, column(frame, side), row(frame, side)),
                (double) width / divisor,
                (double) height / divisor);
        triangle.draw();
    }

    private void join(FullScreenTriangle triangle) {
        if (joining == null) {
            joining = new JoinProgram(context);
        }
        joined.bind();
        gl.state().set(DrawState.Depth.OFF, DrawState.Blend.REPLACE, DrawState.Cull.NONE);
        shown.colour().bind(TextureUnit.COLOURS);
        joining.use();
        triangle.draw();
    }

    int divisor() {
        return divisor;
    }

    void bindPicture() {
        joined.colour().bind(TextureUnit.COLOURS);
    }

    @Override
    public void close() {
        if (shown != null) {
            shown.close();
            joined.close();
            shown = null;
        }
        if (other != null) {
            other.close();
            fresh.close();
            other = null;
            fresh = null;
        }
        before = null;
    }
}
