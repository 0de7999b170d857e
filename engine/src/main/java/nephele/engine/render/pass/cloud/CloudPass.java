package nephele.engine.render.pass.cloud;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.drawn.TechniqueFade;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
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
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.DrawState.Stencil;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.OwnedObjects;
import nephele.engine.render.resource.AmbientLight;
import nephele.engine.render.resource.FrameClouds;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.render.resource.RendererClouds;
import nephele.engine.scene.View;

/**
 * Draws clouds, each by its technique, the farthest first. At less than full resolution they are drawn into a layer as if
 * there were no surfaces, which is drawn where there is none, and into one of {@link SurfaceClouds} for the other pixels.
 *
 * <p>While techniques change, a cloud has a drawing by each of them, the later ones over the earlier ones; those of
 * techniques that are gone are closed.
 */
public final class CloudPass implements Pass {
    private static final List<CloudPixels> CUTS = List.of(CloudPixels.BEFORE_NEAREST, CloudPixels.BEFORE_FARTHEST);

    private final GlContext gl;
    private final RendererClouds levelClouds;
    private final LoadContext context;
    private final TargetReads reads = TargetReads.of(Target.VIEW_DEPTH);
    private final FullScreenTriangle triangle;
    /** The one for {@code auto} first. */
    private final List<CloudDrawing.Technique> techniques;

    private final List<PlacedCloud> clouds = new ArrayList<>();

    /** The clouds with their drawings, in the order in which they are drawn. */
    private final List<Entry> entries = new ArrayList<>();
    /** Builds what ends with the change of techniques; {@code null} without one. */
    private LoadContext passing;

    private final List<FrameClouds> passingClouds = new ArrayList<>();
    private final CloudRanges ranges;
    private final CloudCanvas canvas;
    private final Aabb surfaces;
    /** {@code null} if there are to be none. */
    private final Impostors impostors;

    /** The layer of the main view, whose rays several frames may share; {@code null} if clouds are drawn directly. */
    private final CloudLayer mainLayer;

    /** The layer of all views but the main one. */
    private final CloudLayer nestedLayer;

    /** Clouds in front of surfaces; {@code null} if clouds are drawn directly. */
    private final SurfaceClouds beforeSurfaces;

    /** {@code null} without lightning. */
    private final CloudFlash flash;

    /**
     * A cloud with its drawing by one technique.
     *
     * @param clouds sampled for that technique
     * @param stages of the change in which the technique draws the cloud
     * @param flashed draws the light of a flash in the cloud; {@code null} without lightning, and for a technique that goes
     */
    private record Entry(
            PlacedCloud cloud,
            FrameClouds clouds,
            List<List<CloudTechnique>> stages,
            CloudDrawing drawing,
            CloudDrawing flashed) {
        CloudDrawing drawing(CloudPixels pixels) {
            return pixels.isLook() ? drawing : flashed;
        }

        boolean isDrawn() {
            return cloud.presence() > 0 && cloud.fractionDrawn() > 0;
        }

        private void follow(FrameContext frame, boolean isFlash, TechniqueFade fade) {
            double drawn = 0;
            for (List<CloudTechnique> stage : stages) {
                drawn += fade.fraction(stage);
            }
            cloud.fractionDrawn(Math.min(1, drawn));
            CloudInterval now = clouds.now();
            cloud.follow(now);
            drawing.follow(frame.frameState().environment(), now);
            if (isFlash && flashed != null && flashed != drawing) {
                flashed.follow(frame.frameState().environment(), now);
            }
        }
    }

    /** The techniques of a stage with the clouds that are sampled for them. */
    private record PassingStage(List<CloudTechnique> techniques, FrameClouds clouds) {}

    private CloudPass(LoadContext context, List<CloudDrawing.Technique> techniques) {
        this.context = context;
        this.techniques = techniques;
        gl = context.gl();
        levelClouds = context.get(RendererClouds.RESOURCE);
        FrameLightning lightning = context.get(FrameLightning.RESOURCE);
        triangle = context.own(new FullScreenTriangle(gl, "clouds"));
        List<CloudSource> sources = levelClouds.current().sources();
        for (int i = 0; i < sources.size(); i++) {
            clouds.add(new PlacedCloud(sources.get(i), i));
        }
        ranges = new CloudRanges(clouds);
        canvas = new CloudCanvas(lightning);
        surfaces = context.scene().statics().bounds();
        Quality quality = context.quality();
        int divisor = (int) Math.round(1 / quality.cloudResolution());
        int side = quality.cloudHistory().side();
        impostors = quality.impostors() == Quality.ImpostorChoice.AUTO ? new Impostors(context, divisor, side) : null;
        boolean isLayered = !clouds.isEmpty() && (divisor > 1 || side > 1);
        mainLayer = isLayered ? context.own(new CloudLayer(context, divisor, side, ranges.count())) : null;
        nestedLayer = isLayered ? context.own(new CloudLayer(context, divisor, 1, ranges.count())) : null;
        beforeSurfaces = isLayered ? context.own(new SurfaceClouds(context, 2 * divisor)) : null;
        flash = lightning == null ? null : new CloudFlash(context, divisor, ranges.count());
        addDrawings(new CloudContext(context, impostors));
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

    /** Builds the drawings, while techniques change those of all its stages. */
    private void addDrawings(CloudContext inPass) {
        TechniqueFade fade = levelClouds.fade();
        List<PassingStage> stages = fade.isComplete() ? List.of() : stages(fade);
        for (PlacedCloud cloud : clouds) {
            if (stages.isEmpty()) {
                entries.add(remaining(cloud, List.of(fade.techniques()), inPass));
            } else {
                addRuns(cloud, stages, inPass);
            }
        }
    }

    private List<PassingStage> stages(TechniqueFade fade) {
        passing = context.ownedBy(context.own(new OwnedObjects(gl)));
        List<PassingStage> stages = new ArrayList<>();
        for (TechniqueFade.Stage stage : fade.stages()) {
            boolean remains = stage.techniques().equals(fade.techniques());
            FrameClouds clouds =
                    remains ? levelClouds.current() : levelClouds.sampledFor(stage.techniques(), passing.owner());
            if (!remains) {
                passingClouds.add(clouds);
            }
            stages.add(new PassingStage(stage.techniques(), clouds));
        }
        return stages;
    }

    /** Adds a drawing for each run of stages in which the cloud has one technique. */
    private void addRuns(PlacedCloud cloud, List<PassingStage> stages, CloudContext inPass) {
        int first = 0;
        while (first < stages.size()) {
            int end = first + 1;
            while (end < stages.size() && technique(stages.get(end), cloud) == technique(stages.get(first), cloud)) {
                end++;
            }
            List<PassingStage> run = stages.subList(first, end);
            List<List<CloudTechnique>> runTechniques =
                    run.stream().map(PassingStage::techniques).toList();
            boolean remains = runTechniques.contains(levelClouds.fade().techniques());
            entries.add(
                    remains
                            ? remaining(cloud, runTechniques, inPass)
                            : passing(cloud, run.get(0), runTechniques, inPass));
            first = end;
        }
    }

    private static CloudTechnique technique(PassingStage stage, PlacedCloud cloud) {
        return source(stage, cloud).cloud().technique();
    }

    private static CloudSource source(PassingStage stage, PlacedCloud cloud) {
        return stage.clouds.sources().get(cloud.index());
    }

    private Entry passing(
            PlacedCloud cloud, PassingStage stage, List<List<CloudTechnique>> stages, CloudContext inPass) {
        var before = new PlacedCloud(source(stage, cloud), cloud.index());
        var own = new CloudContext(passing.with(levelClouds.chosenFor(stages.get(0))), null);
        CloudDrawing drawing = drawn(before.source()).build().apply(own, before);
        return new Entry(before, stage.clouds, stages, drawing, null);
    }

    private Entry remaining(PlacedCloud cloud, List<List<CloudTechnique>> stages, CloudContext inPass) {
        CloudDrawing.Technique technique = drawn(cloud.source());
        CloudDrawing drawing = technique.build().apply(inPass, cloud);
        // Flashes light the cells of a cloud whatever draws it, by the technique for auto.
        CloudDrawing.Technique marched = techniques.get(0);
        CloudDrawing flashed = flash == null
                ? null
                : technique == marched ? drawing : marched.build().apply(inPass, cloud);
        return new Entry(cloud, levelClouds.current(), stages, drawing, flashed);
    }

    /** Returns the technique of a cloud; the first one for {@code auto} and where the authored one cannot draw it. */
    private CloudDrawing.Technique drawn(CloudSource cloud) {
        return techniques.stream()
                .filter(known -> known.technique() == cloud.cloud().technique()
                        && known.canDraw().test(cloud))
                .findFirst()
                .orElse(techniques.get(0));
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
        followClouds(frame, isFlash);
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
            draw(CloudPixels.ALL, view, null, Double.POSITIVE_INFINITY);
        } else {
            drawLayered(frame, now, mixed);
        }
        if (isFlash) {
            drawFlash(frame, now, mainLayer == null || mixed);
        }
    }

    /** Takes the clouds at the time of the frame, the farthest from an eye first. */
    private void followClouds(FrameContext frame, boolean isFlash) {
        TechniqueFade fade = levelClouds.fade();
        if (passing != null && fade.isComplete()) {
            entries.removeIf(entry -> entry.clouds != levelClouds.current());
            passingClouds.clear();
            passing.owner().close();
            passing = null;
        }
        Vec3 eye = frame.view().eye();
        for (FrameClouds clouds : passingClouds) {
            clouds.follow(frame.frameState(), levelClouds.current().focus());
        }
        for (int i = 0; i < entries.size(); i++) {
            entries.get(i).follow(frame, isFlash, fade);
        }
        for (int i = 0; i < entries.size(); i++) {
            entries.get(i).drawing.prepare(frame.view());
        }
        if (entries.size() > 1) {
            entries.sort(Comparator.comparingDouble(entry -> -entry.cloud.distance(eye)));
        }
    }

    private static boolean isMain(FrameContext frame) {
        return frame.node() == null || frame.node().parent() == null;
    }

    private void drawLayered(FrameContext frame, CloudInterval now, boolean mixed) {
        View view = frame.view();
        CloudLayer layer = isMain(frame) ? mainLayer : nestedLayer;
        layer.begin(frame.surface(), levelClouds.cuts(), now.seconds());
        draw(CloudPixels.WHOLE, view, layer.grid(), Double.POSITIVE_INFINITY);
        layer.end(view, nearest(view.eye()), triangle);
        frame.surface().bind();
        if (mixed) {
            drawMixed(frame, layer);
        } else {
            layer.draw(Blend.COVER, triangle);
        }
    }

    /**
     * Draws the layer, the clouds in front of surfaces, and on their own those of pixels that get neither. The stencil
     * counts the others meanwhile.
     */
    private void drawMixed(FrameContext frame, CloudLayer layer) {
        View view = frame.view();
        DrawState state = gl.state();
        double farthest = farthestSurface(view.eye());
        beforeSurfaces.begin(frame.surface(), triangle);
        for (CloudPixels cut : CUTS) {
            beforeSurfaces.begin(cut);
            draw(cut, view, beforeSurfaces.grid(cut), farthest);
        }
        beforeSurfaces.end(triangle);
        frame.surface().bind();
        int depth = frame.nested() == null ? 0 : frame.nested().openingsCounted(frame.node());
        state.stencil(Stencil.EQUAL_COUNT_UP, depth);
        layer.draw(Blend.COVER, triangle);
        beforeSurfaces.drawOver(triangle);
        state.stencil(Stencil.EQUAL, depth);
        draw(CloudPixels.BEFORE_OWN, view, beforeSurfaces.grid(CloudPixels.BEFORE_OWN), farthest);
        state.stencil(Stencil.EQUAL_COUNT_DOWN, depth + 1);
        beforeSurfaces.unmark(triangle);
        state.stencil(depth == 0 ? Stencil.OFF : Stencil.EQUAL, depth);
    }

    private void drawFlash(FrameContext frame, CloudInterval now, boolean mixed) {
        View view = frame.view();
        flash.beginBolt();
        draw(CloudPixels.BOLT, view, null, Double.POSITIVE_INFINITY);
        flash.endBolt();
        flash.layer().begin(frame.surface(), levelClouds.cuts(), now.seconds());
        draw(CloudPixels.FLASH, view, flash.layer().grid(), Double.POSITIVE_INFINITY);
        flash.layer().end(view, nearest(view.eye()), triangle);
        flash.add(frame, mixed ? ranges : null, triangle);
    }

    /**
     * Draws the clouds that begin nearer than {@code farthest}, metres.
     *
     * @param grid of a layer; {@code null} for the view itself
     */
    private void draw(CloudPixels pixels, View view, CloudCanvas.Grid grid, double farthest) {
        boolean isView = pixels == CloudPixels.ALL || pixels == CloudPixels.BEFORE_OWN;
        Blend blend = isView ? Blend.COVER : Blend.PREMULTIPLIED_OVER;
        canvas.begin(pixels, view, levelClouds.current().focus(), grid);
        for (int i = 0; i < entries.size(); i++) {
            Entry entry = entries.get(i);
            CloudDrawing drawing = entry.drawing(pixels);
            if (drawing != null && entry.isDrawn() && entry.cloud.distance(view.eye()) < farthest) {
                gl.state().set(Depth.OFF, blend, Cull.NONE);
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
