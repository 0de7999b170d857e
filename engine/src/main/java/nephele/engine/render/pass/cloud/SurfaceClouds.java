package nephele.engine.render.pass.cloud;

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

/**
 * Clouds in front of surfaces, with one ray for a block of pixels. The ray is cut twice, at the nearest and at the farthest
 * surface of the block and of the blocks around it, and a pixel takes what is in front of its own surface from both. So a
 * pixel at an edge, whose surface is one of the two, gets exactly the light in front of it, and no edge has a halo. On a
 * plane one cut in its middle serves both. Views may share it in turn.
 */
final class SurfaceClouds implements GlObject {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/";

    private final GlContext gl;
    private final LoadContext context;
    private final int divisor;
    private final DrawState.Limits limits = new DrawState.Limits();
    private int width;
    private int height;
    /** Nearest and farthest surface of each block; {@code null} before the first view, as are the following. */
    private RenderTarget ends;

    private RenderTarget cuts;
    private RenderTarget nearest;
    private RenderTarget farthest;
    /** Both, a pixel for each corner of blocks. */
    private RenderTarget joined;

    private RenderTarget joinedCuts;

    private GlProgram<Uniforms.None> findEnds;
    private GlProgram<Uniforms.None> findCuts;
    private GlProgram<Uniforms.None> join;
    private GlProgram<Uniforms.None> joinCuts;
    private GlProgram<Uniforms.None> over;
    private GlProgram<Uniforms.None> nothing;

    /** @param divisor pixels of the view along each side of a block */
    SurfaceClouds(LoadContext context, int divisor) {
        this.context = context;
        this.divisor = divisor;
        gl = context.gl();
    }

    /** Begins a view, whose copied depth is bound: finds the cuts of its blocks. */
    void begin(RenderTarget surface, FullScreenTriangle triangle) {
        if (ends == null || width != surface.width() || height != surface.height()) {
            resize(surface);
        }
        gl.state().beginLayer(divisor, limits);
        draw(ends, findEnds, triangle);
        ends.colour().bind(TextureUnit.SURFACE_ENDS);
        draw(cuts, findCuts, triangle);
        cuts.colour().bind(TextureUnit.COLOURS);
        draw(joinedCuts, joinCuts, triangle);
    }

    private void resize(RenderTarget surface) {
        close();
        width = surface.width();
        height = surface.height();
        ends = surface.reduced("ends of surfaces", PixelFormat.RG32F, divisor);
        cuts = surface.reduced("cuts at surfaces", PixelFormat.RG32F, divisor);
        nearest = surface.reduced("clouds before nearest surfaces", PixelFormat.RGBA16F, divisor);
        farthest = surface.reduced("clouds before farthest surfaces", PixelFormat.RGBA16F, divisor);
        joinedCuts = RenderTarget.picture(
                gl, "joined cuts", PixelFormat.RG32F, cuts.width() + 1, cuts.height() + 1, Sampling.LINEAR_CLAMP);
        joined = RenderTarget.pair(
                gl,
                "joined clouds before surfaces",
                PixelFormat.RGBA16F,
                nearest.width() + 1,
                nearest.height() + 1,
                Sampling.LINEAR_CLAMP);
        if (join == null) {
            findEnds = program("surface/ends.frag");
            findCuts = program("surface/cuts.frag");
            join = program("surface/join.frag");
            joinCuts = program("join.frag");
            over = program("surface/over.frag");
            nothing = program("nothing.frag");
        }
    }

    private GlProgram<Uniforms.None> program(String fragment) {
        Defines defines = Defines.of(context).with("FARTHEST").with("DIVISOR", (double) divisor);
        return GlProgram.of(gl, FOLDER + "cloud.vert", FOLDER + fragment, defines.values(), Uniforms.None.class);
    }

    /** Returns the rays of blocks, or of single pixels. */
    CloudCanvas.Grid grid(CloudPixels pixels) {
        int side = pixels == CloudPixels.BEFORE_OWN ? 1 : divisor;
        return new CloudCanvas.Grid(1, 0, 0, 2.0 * side / width, 2.0 * side / height, 0, 0);
    }

    /** Begins the target of clouds in front of one cut, empty. */
    void begin(CloudPixels cut) {
        (cut == CloudPixels.BEFORE_NEAREST ? nearest : farthest).clearTransparentWithinScissor();
        cuts.colour().bind(TextureUnit.SURFACE_CUTS);
    }

    /** Ends both targets and restores the limits of the view. */
    void end(FullScreenTriangle triangle) {
        nearest.colour().bind(TextureUnit.BEFORE_NEAREST);
        farthest.colour().bind(TextureUnit.BEFORE_FARTHEST);
        draw(joined, join, triangle);
        gl.state().endLayer(limits);
    }

    private void draw(RenderTarget target, GlProgram<Uniforms.None> program, FullScreenTriangle triangle) {
        target.bind();
        gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
        program.use();
        triangle.draw();
    }

    /** Draws them over the surfaces of the bound view, but for those clearly between the cuts of their block. */
    void drawOver(FullScreenTriangle triangle) {
        gl.state().set(Depth.GREATER, Blend.COVER, Cull.NONE);
        over.use();
        joined.colour().bind(TextureUnit.BEFORE_NEAREST);
        joined.second().bind(TextureUnit.BEFORE_FARTHEST);
        joinedCuts.colour().bind(TextureUnit.SURFACE_CUTS);
        triangle.draw();
    }

    /** Changes the stencil, as it is set to, of every pixel. */
    void unmark(FullScreenTriangle triangle) {
        gl.state().set(Depth.ALWAYS_ONLY_STENCIL, Blend.REPLACE, Cull.NONE);
        nothing.use();
        triangle.draw();
    }

    @Override
    public void close() {
        if (ends != null) {
            ends.close();
            cuts.close();
            nearest.close();
            farthest.close();
            joined.close();
            joinedCuts.close();
            ends = null;
        }
    }
}
