package nephele.engine.render.pass.exposure;

import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.level.Exposure;
import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.level.appearance.LuminanceHistogram;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.PointList;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.render.resource.MeteredExposure;

/**
 * Meters the exposure of the finished linear picture, views through portals included; exists only for exposure auto.
 * The mean luminance of cells, then a histogram of them by additive blending of points, then adaption in one texel: no
 * pixel is read back.
 */
public final class ExposurePass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "exposure", Stage.AFTER_VIEWS, ExposurePass::requiredBy)
            .using(MeteredExposure.RESOURCE, FrameLightning.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/exposure/";
    /** Values of cells without luminance, far below any logarithm. */
    private static final double BLACK = -1000;

    private static final double HIDDEN = -2000;

    private static final int CELLS = LuminanceHistogram.COLUMNS * LuminanceHistogram.ROWS;

    private final GlContext gl;
    private final MeteredExposure exposure;
    /** {@code null} without lightning. */
    private final FrameLightning lightning;

    private final RenderTarget cells;
    private final FullScreenDrawing findCells;
    private final RenderTarget histogram;
    private final PointList points;
    private final GlProgram<?> count;
    private final FullScreenTriangle triangle;
    private final GlProgram<Adaption> adapt;

    private record Adaption(Uniforms.Vector4 stopsAndShares, Uniforms.Scalar hasHistory) {}

    private ExposurePass(LoadContext context) {
        gl = context.gl();
        exposure = context.get(MeteredExposure.RESOURCE);
        lightning = context.get(FrameLightning.RESOURCE);
        cells = context.own(RenderTarget.picture(
                gl, "cells of luminance", PixelFormat.RGBA32F, LuminanceHistogram.COLUMNS, LuminanceHistogram.ROWS));
        findCells = new FullScreenDrawing(context, defines(), FOLDER + "full.vert", FOLDER + "cells.frag");
        histogram = context.own(RenderTarget.picture(
                gl, "histogram of luminance", PixelFormat.RGBA32F, LuminanceHistogram.BINS + 1, 1));
        points = context.own(new PointList(gl, "cells as points", CELLS));
        triangle = context.own(new FullScreenTriangle(gl, "adaption of exposure"));
        Map<String, String> defines = defines().values();
        count = GlProgram.of(gl, FOLDER + "histogram.vert", FOLDER + "histogram.frag", defines);
        adapt = GlProgram.of(gl, FOLDER + "full.vert", FOLDER + "adapt.frag", defines, Adaption.class);
    }

    /** Returns the numbers of the Java twins for their shaders. */
    private static Defines defines() {
        return new Defines()
                .with("COLUMNS", LuminanceHistogram.COLUMNS)
                .with("ROWS", LuminanceHistogram.ROWS)
                .with("SAMPLES", LuminanceHistogram.SAMPLES)
                .with("DARKEST_LOG2", (double) LuminanceHistogram.DARKEST_LOG2)
                .with("BINS_PER_STOP", (double) LuminanceHistogram.BINS_PER_STOP)
                .with("BINS", (double) LuminanceHistogram.BINS)
                .with("STEPS", (double) LuminanceHistogram.STEPS)
                .with("LOW_SHARE", LuminanceHistogram.LOW_SHARE)
                .with("HIGH_SHARE", LuminanceHistogram.HIGH_SHARE)
                .with("DISPLAYED_PER_KEY", AutoExposure.DISPLAYED_PER_KEY)
                .with("CANDELAS_PER_SQUARE_METRE", AutoExposure.CANDELAS_PER_SQUARE_METRE)
                .with("BLACK", BLACK)
                .with("HIDDEN", HIDDEN)
                .with("EXPOSURE_METERED");
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.metersExposure()
                ? List.of(new Required("environment.exposureStops: auto, metered from the picture", ExposurePass::new))
                : List.of();
    }

    @Override
    public Set<Target> reads() {
        return Set.of(Target.SURFACE);
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.EXPOSURE);
    }

    @Override
    public void draw(FrameContext frame) {
        frame.surface().colour().bind(TextureUnit.COLOURS);
        findCells.draw(cells, Depth.OFF);
        cells.colour().bind(TextureUnit.COLOURS);
        histogram.clear(0, 0, 0);
        gl.state().set(Depth.OFF, Blend.ADD, Cull.NONE);
        count.use();
        points.draw();
        histogram.colour().bind(TextureUnit.COLOURS);
        adapt(frame.frameState().environment().exposureStops());
    }

    /** @param wanted a number of stops, where the frame's environment has one, holds at once */
    private void adapt(Exposure wanted) {
        // A flash is over before an eye adapts to it.
        boolean isFlash = lightning != null && lightning.isLit();
        double seconds = isFlash ? 0 : exposure.elapsedSeconds();
        adapt.uniforms()
                .stopsAndShares()
                .set(
                        (float) wanted.stopsOr(AutoExposure.LEAST_STOPS),
                        (float) wanted.stopsOr(AutoExposure.MOST_STOPS),
                        (float) AutoExposure.approach(AutoExposure.BRIGHTENING_PER_SECOND, seconds),
                        (float) AutoExposure.approach(AutoExposure.DARKENING_PER_SECOND, seconds));
        adapt.uniforms().hasHistory().set(wanted.isAuto() && exposure.hasHistory() ? 1 : 0);
        exposure.next().bind();
        gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
        adapt.use();
        triangle.draw();
        exposure.advance();
    }
}
