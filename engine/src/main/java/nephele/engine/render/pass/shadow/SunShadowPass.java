package nephele.engine.render.pass.shadow;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import nephele.engine.level.billboard.PlantedModels;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.SampleRange;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.resource.SolidMesh;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.render.resource.TerrainMesh;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.ShadowFrame;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * Draws the sun's depth map of all solids that can cast a shadow on another, again when the sun, a solid or the observer
 * has changed.
 */
public final class SunShadowPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "shadow.sun", Stage.ONCE_A_FRAME, SunShadowPass::requiredBy)
            .using(SolidMesh.RESOURCE, TerrainMesh.RESOURCE, SurfaceLight.RESOURCE);

    /** Rounding and the rasteriser's rules move an edge by less. */
    private static final int MARGIN_TEXELS = 2;

    private final GlContext gl;
    private final Map<Target, Texture> targets;
    private final SurfaceLight light;
    private final DepthDraw depth;
    /** {@code null} if no billboard casts a shadow. */
    private final BillboardDepth billboards;

    /** {@code null} without models that are drawn as impostors. */
    private final PlantDepth plants;

    private final DepthLayers map;
    private final Identity solids;
    private final Identity models;
    private final Identity planted;
    /** The shapes that plants may stand on; nothing without plants. */
    private final Identity plantsOn;

    private final List<HeightField> ground;
    private List<Content> contents = List.of();
    private Texture.Extent size;

    /** The data on which a map depends. */
    private record Content(
            Identity solids,
            Identity models,
            Identity planted,
            Identity plantsOn,
            Vec3 observer,
            List<HeightField> ground,
            ShadowFrame frame) {
        boolean differsInGroundAlone(Content other) {
            return solids.equals(other.solids)
                    && models.equals(other.models)
                    && planted.equals(other.planted)
                    && plantsOn.equals(other.plantsOn)
                    && Objects.equals(observer, other.observer)
                    && frame.equals(other.frame);
        }
    }

    private SunShadowPass(LoadContext context) {
        gl = context.gl();
        targets = context.targets();
        light = context.get(SurfaceLight.RESOURCE);
        depth = new DepthDraw(context);
        boolean isPlanted = LightRequirements.billboardsCast(context.scene().level());
        billboards = isPlanted ? new BillboardDepth(context) : null;
        map = DepthDraw.layers(context, "sun shadow");
        StaticShapes statics = context.scene().statics();
        solids = new Identity(statics.solids());
        models = new Identity(statics.models());
        ground = statics.ground().stream().map(StaticShape.HeightGrid::field).toList();
        planted = new Identity(isPlanted ? context.scene().level().billboards() : List.of());
        boolean hasPlants = PlantedModels.isIn(context.scene().level());
        plants = hasPlants ? new PlantDepth(context) : null;
        plantsOn = new Identity(hasPlants ? statics : List.of());
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.lightMaps().has(Target.SUN_SHADOW)
                ? List.of(new Required(
                        "environment.sun.castsShadow: " + LightRequirements.surfaces(request.level())
                                + " that shade others",
                        SunShadowPass::new))
                : List.of();
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.SUN_SHADOW);
    }

    @Override
    public void draw(FrameContext context) {
        ShadowFrame frame = light.sunFrame();
        Vec3 observer = observer(context.frameState());
        if (contents.isEmpty()
                || contents.get(0).frame != frame
                || !Objects.equals(contents.get(0).observer, observer)) {
            contents = List.of(new Content(solids, models, planted, plantsOn, observer, ground, frame));
            size = new Texture.Extent(frame.width(), frame.height(), 1);
        }
        Texture texture = map.showing(contents, size, (layer, target, before) -> draw(target, frame, (Content) before));
        targets.put(Target.SUN_SHADOW, texture);
    }

    /** Returns the place on which the billboards' shadows depend besides the sun; {@code null} for none. */
    private Vec3 observer(FrameState state) {
        return billboards == null || state.observer() == null
                ? null
                : state.observer().centre();
    }

    private void draw(RenderTarget target, ShadowFrame frame, Content before) {
        Optional<Texture.Region> part = before != null && before.differsInGroundAlone(contents.get(0))
                ? changedPart(frame, before.ground, ground)
                : Optional.empty();
        if (part.isPresent()) {
            depth.drawPart(target, part.get(), frustum(frame, part.get()), frame.clipFromAnchor(), frame.anchor());
        } else {
            int border = ShadowFrame.BORDER_TEXELS;
            target.clearDepth();
            gl.state().scissor(border, border, frame.width() - 2 * border, frame.height() - 2 * border);
            depth.drawAll(frame.clipFromAnchor(), frame.anchor());
        }
        if (billboards != null) {
            billboards.draw(frame, light.towardsSun(), contents.get(0).observer);
        }
        if (plants != null) {
            plants.draw(frame, light.towardsSun());
        }
        gl.state().noScissor();
    }

    /**
     * Returns the texels that differ between two versions of all terrains; empty if the whole map has to be drawn.
     */
    private static Optional<Texture.Region> changedPart(
            ShadowFrame frame, List<HeightField> before, List<HeightField> after) {
        if (before.size() != after.size()) {
            return Optional.empty();
        }
        double[] ends = {1, 1, 0, 0};
        for (int i = 0; i < after.size(); i++) {
            Optional<SampleRange> range =
                    after.get(i).origin().equals(before.get(i).origin())
                            ? after.get(i).difference(before.get(i))
                            : Optional.empty();
            if (range.isEmpty()) {
                return Optional.empty();
            }
            if (!range.get().isEmpty()) {
                widen(frame, before.get(i), range.get(), ends);
                widen(frame, after.get(i), range.get(), ends);
            }
        }
        int left = texel(ends[0], frame.width(), -MARGIN_TEXELS);
        int bottom = texel(ends[1], frame.height(), -MARGIN_TEXELS);
        int right = texel(ends[2], frame.width(), 1 + MARGIN_TEXELS);
        int top = texel(ends[3], frame.height(), 1 + MARGIN_TEXELS);
        return Optional.of(new Texture.Region(left, bottom, Math.max(0, right - left), Math.max(0, top - bottom)));
    }

    /** Widens the ends, in fractions of the map, by the samples and those around them. */
    private static void widen(ShadowFrame frame, HeightField field, SampleRange range, double[] ends) {
        int lastColumn = Math.min(range.lastColumn() + 1, field.cellColumns());
        int lastRow = Math.min(range.lastRow() + 1, field.cellRows());
        for (int row = Math.max(0, range.firstRow() - 1); row <= lastRow; row++) {
            for (int column = Math.max(0, range.firstColumn() - 1); column <= lastColumn; column++) {
                Vector3d at = new Vector3d(
                        field.x(column) - frame.anchor().x(),
                        field.y(field.height(column, row)) - frame.anchor().y(),
                        field.z(row) - frame.anchor().z());
                frame.mapFromAnchor().transformPosition(at);
                ends[0] = Math.min(ends[0], at.x);
                ends[1] = Math.min(ends[1], at.y);
                ends[2] = Math.max(ends[2], at.x);
                ends[3] = Math.max(ends[3], at.y);
            }
        }
    }

    private static int texel(double fraction, int texels, int more) {
        int border = ShadowFrame.BORDER_TEXELS;
        return (int) Math.max(border, Math.min(Math.floor(fraction * texels) + more, texels - border));
    }

    /** Returns what the texels of a part of the map may show. */
    private static Frustum frustum(ShadowFrame frame, Texture.Region texels) {
        double width = Math.max(texels.width(), 1) / (double) frame.width();
        double height = Math.max(texels.height(), 1) / (double) frame.height();
        Matrix4d part = new Matrix4d()
                .translation(-1, -1, -1)
                .scale(2 / width, 2 / height, 2)
                .translate(-texels.x() / (double) frame.width(), -texels.y() / (double) frame.height(), 0)
                .mul(frame.mapFromAnchor());
        return Frustum.of(part, frame.anchor());
    }
}
