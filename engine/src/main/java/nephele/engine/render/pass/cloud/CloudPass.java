package nephele.engine.render.pass.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.level.Cloud;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.resource.AmbientLight;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.render.resource.RendererClouds;
import nephele.engine.scene.View;

/**
 * Draws clouds, each by its technique, the farthest first. At less than full resolution they are drawn into a layer as if
 * there were no surfaces, which is drawn where surfaces are behind all clouds; pixels whose surface is among the clouds are
 * drawn on their own, so that no edge of a wall has a halo.
 */
public final class CloudPass implements Pass {
    private final GlContext gl;
    private final RendererClouds levelClouds;
    private final LoadContext context;
    private final TargetReads reads = TargetReads.of(Target.VIEW_DEPTH);
    private final FullScreenTriangle triangle;
    private final CloudEntries entries;
    private final List<PlacedCloud> clouds = new ArrayList<>();
    private final CloudRanges ranges;
    private final CloudCanvas canvas;
    private final Aabb surfaces;
    /** {@code null} if there are to be none. */
    private final Impostors impostors;

    /** The layer of the main view, whose rays several frames may share; {@code null} if clouds are drawn directly. */
    private final CloudLayer mainLayer;

    /** The layer of all views but the main one. */
    private final CloudLayer nestedLayer;

    /** {@code null} without lightning. */
    private final CloudFlash flash;

    private CloudPass(LoadContext context, List<CloudDrawing.Technique> techniques) {
        this.context = context;
        gl = context.gl();
        levelClouds = context.get(RendererClouds.RESOURCE);
        FrameLightning lightning = context.get(FrameLightning.RESOURCE);
        triangle = context.own(new FullScreenTriangle(gl, "clouds"));
        List<CloudSource> sources = levelClouds.current().sources();
        for (int i = 0; i < sources.size(); i++) {
            clouds.add(new PlacedCloud(sources.get(i), i));
        }
        ranges = new CloudRanges(clouds);
        canvas = new CloudCanvas(ranges, lightning);
        surfaces = context.scene().statics().bounds();
        Quality quality = context.quality();
        int divisor = (int) Math.round(1 / quality.cloudResolution());
        int side = quality.cloudHistory().side();
        impostors = quality.impostors() == Quality.ImpostorChoice.AUTO ? new Impostors(context, divisor, side) : null;
        entries = new CloudEntries(new CloudContext(context, impostors, ranges.count()), clouds, techniques);
        boolean isLayered = !clouds.isEmpty() && (divisor > 1 || side > 1);
        mainLayer = isLayered ? context.own(new CloudLayer(context, divisor, side, ranges.count())) : null;
        nestedLayer = isLayered ? context.own(new CloudLayer(context, divisor, 1, ranges.count())) : null;
        flash = lightning == null ? null : new CloudFlash(context, divisor, ranges.count());
    }

    /** Returns the feature with these techniques, the one for {@code auto} first. */
    public static RenderFeature feature(List<CloudDrawing.Technique> techniques) {
        return new RenderFeature("clouds", Stage.IN_VIEWS_AFTER_OPAQUE, request -> requiredBy(request, techniques))
                .using(RendererClouds.RESOURCE, FrameLightning.RESOURCE, AmbientLight.RESOURCE);
    }

    private static List<Required> requiredBy(FrameRequest request, List<CloudDrawing.Technique> techniques) {
        List<Cloud> clouds = WeatherClouds.all(request.level().environment());
        return clouds.isEmpty()
                ? List.of()
                : List.of(new Required(
                        "environment.clouds: " + clouds.size() + " to draw",
                        context -> new CloudPass(context, techniques)));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public Set<Target> writes() {
        return flash == null ? Set.of() : Set.of(Target.BOLT_TRANSMITTANCE);
    }

    @Override
    public boolean needsCopies(FrameContext frame) {
        return !clouds.isEmpty() && (mainLayer == null || isMixed(frame.view().eye()));
    }

    /** Returns true if surfaces can be among the clouds that an eye sees. */
    private boolean isMixed(Vec3 eye) {
        double seconds = levelClouds.current().now().seconds();
        return nearest(eye).bounds(seconds).nearest(eye) < farthestSurface(eye);
    }

    /** Returns the cloud whose bounds are nearest to an eye. */
    private PlacedCloud nearest(Vec3 eye) {
        double seconds = levelClouds.current().now().seconds();
        double least = Double.POSITIVE_INFINITY;
        PlacedCloud nearest = null;
        for (int i = 0; i < clouds.size(); i++) {
            double metres = clouds.get(i).bounds(seconds).nearest(eye);
            if (nearest == null || metres < least) {
                least = metres;
                nearest = clouds.get(i);
            }
        }
        return nearest;
    }

    @Override
    public void draw(FrameContext frame) {
        if (clouds.isEmpty()) {
            return;
        }
        View view = frame.view();
        CloudInterval now = levelClouds.current().now();
        boolean isFlash = flash != null && flash.isLit();
        entries.follow(frame, isFlash);
        ranges.follow(clouds);
        if (impostors != null && isMain(frame)) {
            impostors.follow(frame);
        }
        boolean mixed = isMixed(view.eye());
        if (mainLayer == null || mixed) {
            reads.bind(context.targets());
        }
        if (mainLayer == null) {
            frame.surface().bind();
            draw(CloudPixels.ALL, view, null);
        } else {
            drawLayered(frame, now, mixed);
        }
        if (isFlash) {
            drawFlash(frame, now, mainLayer == null || mixed);
        }
    }

    private static boolean isMain(FrameContext frame) {
        return frame.node() == null || frame.node().parent() == null;
    }

    private void drawLayered(FrameContext frame, CloudInterval now, boolean mixed) {
        View view = frame.view();
        CloudLayer layer = isMain(frame) ? mainLayer : nestedLayer;
        layer.begin(frame.surface(), levelClouds.cuts(), now.seconds());
        draw(CloudPixels.WHOLE, view, layer);
        layer.end(view, nearest(view.eye()), triangle);
        frame.surface().bind();
        layer.draw(Blend.PREMULTIPLIED_OVER, mixed ? ranges : null, view, triangle);
        if (mixed) {
            draw(CloudPixels.MIXED, view, null);
        }
    }

    private void drawFlash(FrameContext frame, CloudInterval now, boolean mixed) {
        View view = frame.view();
        flash.beginBolt();
        draw(CloudPixels.BOLT, view, null);
        flash.endBolt();
        flash.layer().begin(frame.surface(), levelClouds.cuts(), now.seconds());
        draw(CloudPixels.FLASH, view, flash.layer());
        flash.layer().end(view, nearest(view.eye()), triangle);
        flash.add(frame, mixed ? ranges : null, triangle);
    }

    /** @param layer into which is drawn; {@code null} for the view itself */
    private void draw(CloudPixels pixels, View view, CloudLayer layer) {
        canvas.begin(pixels, view, levelClouds.current().focus(), layer == null ? null : layer.grid());
        List<CloudEntries.Entry> all = entries.all();
        for (int i = 0; i < all.size(); i++) {
            CloudDrawing drawing = all.get(i).drawing(pixels);
            if (drawing != null && all.get(i).isDrawn()) {
                gl.state().set(Depth.OFF, Blend.PREMULTIPLIED_OVER, Cull.NONE);
                drawing.draw(canvas);
            }
        }
    }

    private double farthestSurface(Vec3 eye) {
        if (surfaces.isEmpty()) {
            return 0;
        }
        return surfaces.farthest(eye.x(), eye.y(), eye.z());
    }
}
