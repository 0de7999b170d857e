package nephele.engine.render.pass.cloud.volume;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
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
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.pass.cloud.volume.MarchProgram.Pixels;
import nephele.engine.scene.View;

/**
 * Draws clouds by marching rays through their cells, the farthest cloud first. At less than full resolution they are
 * marched into a layer as if there were no surfaces, which is drawn where surfaces are behind all clouds; pixels whose
 * surface is among the clouds are marched on their own, so that no edge of a wall has a halo.
 */
public final class VolumePass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("cloud.volume", Stage.IN_VIEWS_AFTER_OPAQUE, VolumePass::requiredBy);

    private final GlContext gl;
    private final SharedResources shared;
    private final LoadContext context;
    private final TargetReads reads = TargetReads.of(Target.VIEW_DEPTH);
    private final FullScreenTriangle triangle;
    private final List<MarchedCloud> clouds;
    private final CloudRanges ranges;
    private final Aabb surfaces;
    private final double stepCells;
    /** The layer of the main view, whose rays several frames may share; {@code null} if clouds are marched directly. */
    private final CloudLayer mainLayer;

    /** That of all other views. */
    private final CloudLayer nestedLayer;

    private final MarchPrograms whole;
    private final MarchPrograms direct;
    private CompositeProgram composite;
    private CompositeProgram compositeBehindSurfaces;

    private VolumePass(LoadContext context) {
        this.context = context;
        gl = context.gl();
        shared = context.shared();
        triangle = context.own(new FullScreenTriangle(gl, "volume"));
        clouds = new ArrayList<>();
        List<CloudSource> sources = shared.clouds().sources();
        for (int i = 0; i < sources.size(); i++) {
            clouds.add(new MarchedCloud(context, sources.get(i), i));
        }
        ranges = new CloudRanges(clouds);
        surfaces = context.scene().statics().bounds();
        Quality quality = context.quality();
        stepCells = quality.cloudStep();
        int divisor = (int) Math.round(1 / quality.cloudResolution());
        int side = quality.cloudHistory().side();
        boolean isLayered = !clouds.isEmpty() && (divisor > 1 || side > 1);
        mainLayer = isLayered ? context.own(new CloudLayer(context, divisor, side)) : null;
        nestedLayer = isLayered ? context.own(new CloudLayer(context, divisor, 1)) : null;
        whole = isLayered ? new MarchPrograms(context, Pixels.WHOLE, 0) : null;
        direct = clouds.isEmpty()
                ? null
                : new MarchPrograms(context, mainLayer == null ? Pixels.ALL : Pixels.MIXED, ranges.count());
    }

    private static List<Required> requiredBy(FrameRequest request) {
        List<Cloud> clouds = WeatherClouds.all(request.level().environment());
        return clouds.isEmpty()
                ? List.of()
                : List.of(new Required(
                        "environment.clouds: " + clouds.size() + " drawn by technique volume", VolumePass::new));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public boolean needsCopies(FrameContext frame) {
        return !clouds.isEmpty() && (mainLayer == null || isMixed(frame.view().eye()));
    }

    /** Returns true if surfaces can be among the clouds that an eye sees. */
    private boolean isMixed(Vec3 eye) {
        double seconds = shared.clouds().now().seconds();
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < clouds.size(); i++) {
            nearest = Math.min(nearest, CloudRanges.distance(clouds.get(i).bounds(seconds), eye));
        }
        return nearest < farthestSurface(eye);
    }

    @Override
    public void draw(FrameContext frame) {
        if (clouds.isEmpty()) {
            return;
        }
        View view = frame.view();
        for (int i = 0; i < clouds.size(); i++) {
            clouds.get(i).follow(frame.frameState().environment());
            clouds.get(i).follow(shared.clouds().now());
        }
        sort(view.eye());
        ranges.follow(clouds);
        if (mainLayer == null) {
            reads.bind(shared);
            frame.surface().bind();
            march(direct, view, null);
            return;
        }
        boolean isMain = frame.node() == null || frame.node().parent() == null;
        CloudLayer layer = isMain ? mainLayer : nestedLayer;
        layer.begin(frame.surface(), shared.cuts(), shared.clouds().now().seconds());
        march(whole, view, layer);
        layer.end(view, triangle);
        frame.surface().bind();
        boolean mixed = isMixed(view.eye());
        if (mixed) {
            reads.bind(shared);
        }
        drawLayer(layer, view, mixed);
        if (mixed) {
            march(direct, view, null);
        }
    }

    private void sort(Vec3 eye) {
        if (clouds.size() > 1) {
            clouds.sort(Comparator.comparingDouble(cloud -> -CloudRanges.distance(cloud.bounds(), eye)));
        }
    }

    /** @param layer into which is marched; {@code null} for the view itself */
    private void march(MarchPrograms programs, View view, CloudLayer layer) {
        gl.state().set(Depth.OFF, Blend.PREMULTIPLIED_OVER, Cull.NONE);
        for (int i = 0; i < clouds.size(); i++) {
            MarchedCloud cloud = clouds.get(i);
            if (!cloud.isPresent()) {
                continue;
            }
            MarchProgram program = programs.of(cloud.noise());
            program.use();
            if (layer != null) {
                layer.put(program.rays());
                cloud.putBlown(program.rays(), layer.secondsBefore());
            }
            if (program.ranges() != null) {
                ranges.put(program.ranges(), view);
            }
            cloud.bind(program, view, shared.clouds().focus(), stepCells);
            triangle.draw();
        }
    }

    private void drawLayer(CloudLayer layer, View view, boolean mixed) {
        gl.state().set(mixed ? Depth.OFF : Depth.LESS_OR_EQUAL, Blend.PREMULTIPLIED_OVER, Cull.NONE);
        CompositeProgram program = mixed ? compositeBehindSurfaces() : composite();
        program.use();
        if (mixed) {
            ranges.put(program.ranges(), view);
        }
        layer.bindPicture();
        triangle.draw();
    }

    private CompositeProgram composite() {
        if (composite == null) {
            composite = new CompositeProgram(context, false, ranges.count(), mainLayer.divisor());
        }
        return composite;
    }

    private CompositeProgram compositeBehindSurfaces() {
        if (compositeBehindSurfaces == null) {
            compositeBehindSurfaces = new CompositeProgram(context, true, ranges.count(), mainLayer.divisor());
        }
        return compositeBehindSurfaces;
    }

    private double farthestSurface(Vec3 eye) {
        if (surfaces.isEmpty()) {
            return 0;
        }
        double x = Math.max(Math.abs(eye.x() - surfaces.minX()), Math.abs(eye.x() - surfaces.maxX()));
        double y = Math.max(Math.abs(eye.y() - surfaces.minY()), Math.abs(eye.y() - surfaces.maxY()));
        double z = Math.max(Math.abs(eye.z() - surfaces.minZ()), Math.abs(eye.z() - surfaces.maxZ()));
        return Math.sqrt(x * x + y * y + z * z);
    }
}
