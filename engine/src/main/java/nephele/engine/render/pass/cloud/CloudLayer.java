package nephele.engine.render.pass.cloud;

import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.scene.View;

/**
 * The target of low resolution into which clouds are marched. The rays of one view can be divided among frames: a frame
 * marches one of each square of rays, and the others keep what was found in their direction before, at most as many
 * frames ago as a square has rays. The first frame after a cut marches all, as after a jump in time. Views that all march
 * all rays may share a layer in turn.
 */
final class CloudLayer implements GlObject {
    /** A longer time between two frames is a jump: clouds have another shape after it. */
    private static final double JUMP_SECONDS = 1;

    /**
     * As far away as clouds count that a ray may have met before and does not meet now, with the eye in their bounds.
     */
    private static final double NEAREST_KILOMETRES = 0.02;

    private static final double SKY_KILOMETRES = 100;
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/";

    private final GlContext gl;
    private final LoadContext context;
    /** Number of bounds that programs know. */
    private final int clouds;

    private final int divisor;
    private final int side;
    private final DrawState.Limits limits = new DrawState.Limits();
    private RenderTarget layer;
    /** The layer of the frame before, then that of the next; {@code null} without history, as are the following. */
    private RenderTarget other;

    private RenderTarget fresh;
    /** The layer as it is drawn; a pixel for each corner of its pixels. */
    private RenderTarget joined;

    /** Completes a layer of which a frame has marched a part; compiled on first use, as are the following. */
    private GlProgram<SpreadUniforms> spread;

    /** Smooths a layer once, so that a pixel of the view needs one look at it. */
    private GlProgram<Uniforms.None> join;

    /** Draws a layer over the pixels of a view without a surface. */
    private GlProgram<Uniforms.None> composite;

    /** Draws it over surfaces behind all clouds. */
    private GlProgram<CloudRanges.Places> compositeMixed;

    private View before;
    private double seconds;
    private double secondsBefore;
    private int width;
    private int height;
    private int frame;
    private int cuts;

    private record SpreadUniforms(
            Uniforms.Vector2 layerStep,
            Uniforms.Vector3 square,
            Uniforms.Vector3 beforeRight,
            Uniforms.Vector3 beforeUp,
            Uniforms.Vector3 beforeForward,
            Uniforms.Vector3 moved,
            Uniforms.Vector2 halfLayer,
            Uniforms.Scalar nearestKilometres,
            Uniforms.Vector3 movedPast) {}

    /**
     * @param divisor pixels of the view along each side of one of the layer
     * @param side of the square of rays of which a frame marches one; 1 to march all
     * @param clouds number of bounds that programs know
     */
    CloudLayer(LoadContext context, int divisor, int side, int clouds) {
        this.context = context;
        this.clouds = clouds;
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
        if (layer == null || width != surface.width() || height != surface.height()) {
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
        (before == null ? layer : fresh).clearTransparentWithinScissor();
    }

    private void resize(RenderTarget surface) {
        close();
        width = surface.width();
        height = surface.height();
        layer = surface.reduced("clouds", PixelFormat.RGBA16F, divisor);
        joined = RenderTarget.picture(
                gl, "joined clouds", PixelFormat.RGBA16F, layer.width() + 1, layer.height() + 1, Sampling.LINEAR_CLAMP);
        if (side > 1) {
            other = surface.reduced("clouds before", PixelFormat.RGBA16F, divisor);
            int across = (layer.width() + side - 1) / side;
            int up = (layer.height() + side - 1) / side;
            fresh = RenderTarget.pair(gl, "marched clouds", PixelFormat.RGBA16F, across, up, Sampling.NEAREST_CLAMP);
        }
    }

    private int marchedSide() {
        return before == null ? 1 : side;
    }

    /** Returns the rays that the frame marches. */
    CloudCanvas.Grid grid() {
        int n = marchedSide();
        double offset = 0.5 * (1 - n);
        double x = n == 1 ? 0 : column(frame, side);
        double y = n == 1 ? 0 : row(frame, side);
        return new CloudCanvas.Grid(
                n, x + offset, y + offset, 2.0 * divisor / width, 2.0 * divisor / height, 0, secondsBefore);
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
     * @param nearest cloud in the layer, the one that may have moved farthest in the picture
     */
    void end(View view, PlacedCloud nearest, FullScreenTriangle triangle) {
        if (before != null) {
            complete(view, nearest, triangle);
        }
        join(triangle);
        gl.state().endLayer(limits);
        before = side == 1 ? null : view;
    }

    private void complete(View view, PlacedCloud nearest, FullScreenTriangle triangle) {
        if (spread == null) {
            spread = program("spread.frag", Defines.of(context), SpreadUniforms.class);
        }
        RenderTarget completed = other;
        other = layer;
        layer = completed;
        completed.bind();
        gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
        fresh.colour().bind(TextureUnit.SPREAD_FRESH);
        fresh.second().bind(TextureUnit.SPREAD_PLACES);
        other.colour().bind(TextureUnit.SPREAD_BEFORE);
        spread.use();
        put(spread.uniforms(), view, nearest);
        triangle.draw();
    }

    private void put(SpreadUniforms uniforms, View view, PlacedCloud nearest) {
        double across = (double) width / divisor;
        double upwards = (double) height / divisor;
        uniforms.layerStep.set(2 / across, 2 / upwards);
        uniforms.halfLayer.set(across / 2, upwards / 2);
        uniforms.square.set(side, column(frame, side), row(frame, side));
        Vec3 moved = view.eye().minus(before.eye());
        uniforms.moved.set(moved);
        uniforms.movedPast.set(moved.minus(blown(nearest)));
        uniforms.nearestKilometres.set(Math.max(
                NEAREST_KILOMETRES,
                Math.min(SKY_KILOMETRES, nearest.bounds(seconds).nearest(view.eye()) / 1000)));
        uniforms.beforeRight.setScaled(before.right(), 1 / before.projection().tanHalfWidth());
        uniforms.beforeUp.setScaled(before.up(), 1 / before.projection().tanHalfHeight());
        uniforms.beforeForward.setScaled(before.back(), -1);
    }

    /** Returns how far the wind has carried a cloud since the frame before. */
    private Vec3 blown(PlacedCloud cloud) {
        return cloud.source().drift(seconds).minus(cloud.source().drift(secondsBefore));
    }

    private void join(FullScreenTriangle triangle) {
        if (join == null) {
            join = program("join.frag", Defines.of(context), Uniforms.None.class);
        }
        joined.bind();
        gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
        layer.colour().bind(TextureUnit.COLOURS);
        join.use();
        triangle.draw();
    }

    /** Draws the layer over the pixels of the bound view without a surface. */
    void draw(Blend blend, FullScreenTriangle triangle) {
        if (composite == null) {
            composite = program("composite.frag", defines(), Uniforms.None.class);
        }
        gl.state().set(Depth.LESS_OR_EQUAL, blend, Cull.NONE);
        composite.use();
        joined.colour().bind(TextureUnit.COLOURS);
        triangle.draw();
    }

    /** Draws the layer over the surfaces behind all clouds; those among the clouds stay as they are. */
    void drawOverSurfaces(Blend blend, CloudRanges ranges, View view, FullScreenTriangle triangle) {
        if (compositeMixed == null) {
            compositeMixed = program("composite.frag", defines().with("MIXED"), CloudRanges.Places.class);
        }
        gl.state().set(Depth.GREATER, blend, Cull.NONE);
        compositeMixed.use();
        ranges.put(compositeMixed.uniforms(), view);
        joined.colour().bind(TextureUnit.COLOURS);
        triangle.draw();
    }

    private Defines defines() {
        return Defines.of(context).with("FARTHEST").with("CLOUDS", clouds).with("DIVISOR", (double) divisor);
    }

    private <U extends Record> GlProgram<U> program(String fragment, Defines defines, Class<U> uniforms) {
        return GlProgram.of(gl, FOLDER + "cloud.vert", FOLDER + fragment, defines.values(), uniforms);
    }

    @Override
    public void close() {
        if (layer != null) {
            layer.close();
            joined.close();
            layer = null;
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
